#pragma once

#include <array>
#include <functional>
#include <vector>

namespace tentpole {

/// Corners i < k < j of a triangle, as indices into the polygon.
using PolygonTriangle = std::array<int, 3>;

/// Among all triangulations of a polygon with `num_corners` corners the one whose largest triangle cost is smallest
/// (dynamic programming over the diagonals, O(n^3); the first one wins a tie). Empty where each of them has a triangle
/// of infinite cost. If only positively oriented triangles have a finite cost, the result fills the polygon exactly
/// once.
std::vector<PolygonTriangle> best_triangulation(int num_corners,
                                                const std::function<double(const PolygonTriangle&)>& cost);

}  // namespace tentpole
