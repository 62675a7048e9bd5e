#include "host/front/front_simplex.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/mesh/insertion_sort.hpp"
#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {

namespace {

double cross_z(const Point& a, const Point& b) {
  return a[0] * b[1] - a[1] * b[0];
}

double edge_length(const FrontSimplex& cell, int i, int j) {
  return distance(cell.position[i], cell.position[j]);
}

}  // namespace

double signed_measure(const FrontSimplex& cell) {
  const Point a = difference(cell.position[1], cell.position[0]);
  if (cell.dimension == 1) return a[0];
  return cross_z(a, difference(cell.position[2], cell.position[0])) / 2;
}

Point time_gradient(const FrontSimplex& cell) {
  const Point a = difference(cell.position[1], cell.position[0]);
  const double rise_a = cell.time[1] - cell.time[0];
  if (cell.dimension == 1) return {rise_a / a[0], 0, 0};
  const Point b = difference(cell.position[2], cell.position[0]);
  const double rise_b = cell.time[2] - cell.time[0];
  const double determinant = cross_z(a, b);
  return {(rise_a * b[1] - rise_b * a[1]) / determinant, (rise_b * a[0] - rise_a * b[0]) / determinant, 0};
}

double time_slope(const FrontSimplex& cell) {
  const Point gradient = time_gradient(cell);
  return std::sqrt(dot(gradient, gradient));
}

double time_at(const FrontSimplex& cell, const Point& position) {
  return cell.time[0] + dot(time_gradient(cell), difference(position, cell.position[0]));
}

double longest_edge(const FrontSimplex& cell) {
  double longest = edge_length(cell, 0, 1);
  if (cell.dimension == 2) longest = std::max({longest, edge_length(cell, 0, 2), edge_length(cell, 1, 2)});
  return longest;
}

double altitude(const FrontSimplex& cell, int corner) {
  const double measure = std::abs(signed_measure(cell));
  if (cell.dimension == 1) return measure;
  return 2 * measure / edge_length(cell, (corner + 1) % 3, (corner + 2) % 3);
}

double shortest_altitude(const FrontSimplex& cell) {
  return cell.dimension * std::abs(signed_measure(cell)) / (cell.dimension == 1 ? 1 : longest_edge(cell));
}

double smallest_angle_sine(const FrontSimplex& cell) {
  if (cell.dimension == 1) return 1;
  std::array<double, 3> length{edge_length(cell, 0, 1), edge_length(cell, 0, 2), edge_length(cell, 1, 2)};
  insertion_sort(length, 3);
  return 2 * std::abs(signed_measure(cell)) / (length[1] * length[2]);
}

double shape_defect(const FrontSimplex& cell) {
  if (cell.dimension == 1) return 1;
  const double area = signed_measure(cell);
  if (!(area > 0)) return std::numeric_limits<double>::infinity();
  double squares = 0;
  for (int i = 0; i < 3; ++i) {
    const Point edge = difference(cell.position[(i + 1) % 3], cell.position[i]);
    squares += dot(edge, edge);
  }
  return squares / (4 * std::sqrt(3.0) * area);
}

}  // namespace tentpole
