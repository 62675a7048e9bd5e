#include "host/front/progress_rule.hpp"

#include <algorithm>
#include <cmath>

#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {

namespace {

constexpr double obtuse_margin = 0.3;  ///< eps of rule B
constexpr double rounding = 1e-9;

/// Lengths of a triangle's edges (edge i is opposite corner i) and what the rule allows at its corners.
struct TriangleEdges {
  std::array<double, 3> length;
  std::array<double, 3> sine;  ///< of the angle at a corner if it is obtuse, else 1

  /// f_e of the edge opposite corner i.
  double factor(int i) const { return (1 - obtuse_margin) * std::min(sine[(i + 1) % 3], sine[(i + 2) % 3]); }
};

TriangleEdges triangle_edges(const FrontSimplex& cell) {
  TriangleEdges edges{};
  std::array<Point, 3> edge;
  for (int i = 0; i < 3; ++i) {
    edge[i] = difference(cell.position[(i + 2) % 3], cell.position[(i + 1) % 3]);
    edges.length[i] = std::sqrt(dot(edge[i], edge[i]));
  }
  const double double_area = std::abs(edge[0][0] * edge[1][1] - edge[0][1] * edge[1][0]);
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3, last = (i + 2) % 3;
    const bool is_obtuse = dot(edge[next], edge[last]) > 0;  // edges run round the triangle
    edges.sine[i] = is_obtuse ? double_area / (edges.length[next] * edges.length[last]) : 1;
  }
  return edges;
}

/// The upper root of |grad tau| = g for the time of corner `top`.
double causal_limit(const FrontSimplex& cell, int top, double length, double slope_limit) {
  const int first = (top + 1) % 3, second = (top + 2) % 3;
  const Point edge = difference(cell.position[second], cell.position[first]);
  const Point arm = difference(cell.position[top], cell.position[first]);
  const double foot = (arm[0] * edge[0] + arm[1] * edge[1]) / length;
  const double height = std::abs(arm[0] * edge[1] - arm[1] * edge[0]) / length;
  const double slope = (cell.time[second] - cell.time[first]) / length;
  return cell.time[first] + slope * foot + height * std::sqrt(std::max(0.0, slope_limit * slope_limit - slope * slope));
}

}  // namespace

double latest_corner_time(const FrontSimplex& cell, int corner, double slope_limit) {
  if (cell.dimension == 1) return cell.time[1 - corner] + slope_limit * std::abs(signed_measure(cell));
  const TriangleEdges edges = triangle_edges(cell);
  double latest = causal_limit(cell, corner, edges.length[corner], slope_limit);
  for (const int step : {1, 2}) {
    const int other = (corner + step) % 3, third = (corner + 3 - step) % 3;
    latest = std::min(latest, cell.time[other] + edges.factor(third) * slope_limit * edges.length[third]);
  }
  return latest;
}

double edge_limit_use(const FrontSimplex& cell, double slope_limit) {
  if (cell.dimension == 1)
    return std::abs(cell.time[1] - cell.time[0]) / (slope_limit * std::abs(signed_measure(cell)));
  const TriangleEdges edges = triangle_edges(cell);
  double use = 0;
  for (int i = 0; i < 3; ++i) {
    const double rise = std::abs(cell.time[(i + 1) % 3] - cell.time[(i + 2) % 3]);
    use = std::max(use, rise / (edges.factor(i) * slope_limit * edges.length[i]));
  }
  return use;
}

bool may_be_on_front(const FrontSimplex& cell, double slope_limit) {
  return edge_limit_use(cell, slope_limit) <= 1 + rounding && time_slope(cell) <= slope_limit * (1 + rounding);
}

}  // namespace tentpole
