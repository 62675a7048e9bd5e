#include "host/mesh/simplex_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace tentpole {

double distance(const Point& a, const Point& b) {
  const Point d = difference(a, b);
  return std::sqrt(dot(d, d));
}

double signed_simplex_measure(int dimension, const std::array<Point, SpaceMesh::max_corners>& corners) {
  const Point a = difference(corners[1], corners[0]);
  if (dimension == 1) return a[0];
  const Point b = difference(corners[2], corners[0]);
  if (dimension == 2) return (a[0] * b[1] - a[1] * b[0]) / 2;
  return dot(cross(a, b), difference(corners[3], corners[0])) / 6;
}

double longest_edge(int dimension, const std::array<Point, SpaceMesh::max_corners>& corners) {
  double longest = 0;
  for (int i = 0; i <= dimension; ++i)
    for (int j = 0; j < i; ++j) longest = std::max(longest, distance(corners[i], corners[j]));
  return longest;
}

}  // namespace tentpole
