#pragma once

#include <array>

#include "host/mesh/space_mesh.hpp"

namespace tentpole {

/// R_T of progress rule A: max |g| subject to |g . e| <= 1 for the unit vectors e along all edges of the simplex. >= 1.
/// The maximum of the convex |g| lies at a vertex of the polytope, so all choices of D edges and signs are tried.
/// `corners`: the first dimension + 1 are used.
double edge_slope_amplification(int dimension, const std::array<Point, SpaceMesh::max_corners>& corners);

}  // namespace tentpole
