#pragma once

#include <array>

#include "host/mesh/space_mesh.hpp"

namespace tentpole {

/// Length, area or volume of the simplex with these corners (the first dimension + 1), with the sign of the
/// orientation.
double signed_simplex_measure(int dimension, const std::array<Point, SpaceMesh::max_corners>& corners);

/// Longest edge of the simplex.
double longest_edge(int dimension, const std::array<Point, SpaceMesh::max_corners>& corners);

inline Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double distance(const Point& a, const Point& b);

}  // namespace tentpole
