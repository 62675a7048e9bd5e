#include "host/front/front_slope.hpp"

#include <cmath>

#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {

double front_slope(int dimension, const std::array<Point, SpaceMesh::max_corners>& corners,
                   const std::array<double, SpaceMesh::max_corners>& times) {
  const Point a = difference(corners[1], corners[0]);
  const double rise_a = times[1] - times[0];
  if (dimension == 1) return std::abs(rise_a / a[0]);
  const Point b = difference(corners[2], corners[0]);
  const double rise_b = times[2] - times[0];
  if (dimension == 2) {
    const double determinant = a[0] * b[1] - a[1] * b[0];
    const double slope_x = rise_a * b[1] - rise_b * a[1], slope_y = rise_b * a[0] - rise_a * b[0];
    return std::sqrt(slope_x * slope_x + slope_y * slope_y) / std::abs(determinant);
  }
  const Point c = difference(corners[3], corners[0]);
  const double rise_c = times[3] - times[0];
  const Point bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  Point slope{};
  for (int axis = 0; axis < 3; ++axis) slope[axis] = rise_a * bc[axis] + rise_b * ca[axis] + rise_c * ab[axis];
  return std::sqrt(dot(slope, slope)) / std::abs(dot(a, bc));
}

}  // namespace tentpole
