#pragma once

#include <span>

#include "host/mesh/space_mesh.hpp"

namespace tentpole {

/// Twice the area of the triangle (first, second, point): positive if the point lies left of the line from first to
/// second. Exactly the negative when first and second are exchanged, so a point between two triangles is not lost.
double signed_double_area(const Point& first, const Point& second, const Point& point);

/// True in the closed triangle, whatever the orientation of its three corners.
bool is_in_triangle(std::span<const Point> corners, const Point& point);

}  // namespace tentpole
