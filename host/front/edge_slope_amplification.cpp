#include "host/front/edge_slope_amplification.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {

namespace {

std::vector<Point> unit_edges(int dimension, const std::array<Point, SpaceMesh::max_corners>& corners) {
  std::vector<Point> edges;
  for (int i = 0; i <= dimension; ++i)
    for (int j = 0; j < i; ++j) {
      Point edge = difference(corners[i], corners[j]);
      const double length = std::sqrt(dot(edge, edge));
      for (double& component : edge) component /= length;
      edges.push_back(edge);
    }
  return edges;
}

/// |g| of a candidate, or 0 where it breaks the constraint of another edge.
double admissible_length(const std::vector<Point>& edges, const Point& g) {
  for (const Point& edge : edges)
    if (std::abs(dot(edge, g)) > 1 + 1e-9) return 0;
  return std::sqrt(dot(g, g));
}

/// g with g . a = 1, g . b = sign_b and, for D = 3, g . c = sign_c.
Point solve(const Point& a, const Point& b, const Point& c, double sign_b, double sign_c) {
  const Point bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const double determinant = dot(a, bc);
  Point g{};
  for (int axis = 0; axis < 3; ++axis) g[axis] = (bc[axis] + sign_b * ca[axis] + sign_c * ab[axis]) / determinant;
  return g;
}

/// Edges this close to linearly dependent cut out no vertex of their own.
bool are_independent(const Point& a, const Point& b, const Point& c) {
  return std::abs(dot(a, cross(b, c))) > 1e-12;
}

}  // namespace

double edge_slope_amplification(int dimension, const std::array<Point, SpaceMesh::max_corners>& corners) {
  if (dimension == 1) return 1;
  const std::vector<Point> edges = unit_edges(dimension, corners);
  double largest = 1;
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (dimension == 2) {
        // The plane problem as a spatial one: the third edge is the normal, and g has no component along it.
        constexpr Point normal{0, 0, 1};
        for (const double sign : {1.0, -1.0})
          if (are_independent(edges[i], edges[j], normal))
            largest = std::max(largest, admissible_length(edges, solve(edges[i], edges[j], normal, sign, 0)));
        continue;
      }
      for (std::size_t k = 0; k < j; ++k)
        for (const double sign_j : {1.0, -1.0})
          for (const double sign_k : {1.0, -1.0})
            if (are_independent(edges[i], edges[j], edges[k]))
              largest =
                  std::max(largest, admissible_length(edges, solve(edges[i], edges[j], edges[k], sign_j, sign_k)));
    }
  return largest;
}

}  // namespace tentpole
