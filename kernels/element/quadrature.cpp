#include "kernels/element/quadrature.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace tentpole {
namespace {

struct ValueAndSlope {
  long double value, slope;
};

/// Jacobi polynomial P_n^(alpha, 0) and its derivative at y, by the three-term recurrence and its derivative.
ValueAndSlope jacobi(int n, int alpha, long double y) {
  ValueAndSlope previous{0, 0}, current{1, 0};
  for (int m = 0; m < n; ++m) {
    const long double s = 2.0L * m + alpha;
    if (m == 0) {
      previous = current;
      current = {((alpha + 2) * y + alpha) / 2, (alpha + 2) / 2.0L};
      continue;
    }
    const long double scale = 2.0L * (m + 1) * (m + alpha + 1) * s;
    const long double constant = (s + 1) * alpha * alpha / scale, linear = s * (s + 1) * (s + 2) / scale;
    const long double backward = 2.0L * (m + alpha) * m * (s + 2) / scale;
    const ValueAndSlope next{
        (constant + linear * y) * current.value - backward * previous.value,
        linear * current.value + (constant + linear * y) * current.slope - backward * previous.slope};
    previous = current;
    current = next;
  }
  return current;
}

/// The root next to the ones already found: Newton's method on the polynomial divided by (y - root) for each of them.
long double next_root(int n, int alpha, const std::vector<long double>& found) {
  const auto index = static_cast<long double>(found.size());
  long double y = -std::cos((2 * index + 1) / (2 * n) * std::numbers::pi_v<long double>);
  if (!found.empty()) y = (y + found.back()) / 2;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const ValueAndSlope p = jacobi(n, alpha, y);
    long double deflation = 0;
    for (const long double root : found) deflation += 1 / (y - root);
    const long double step = p.value / (p.slope - deflation * p.value);
    y -= step;
    if (std::abs(step) < 1e-18L) break;
  }
  return y;
}

}  // namespace

Quadrature gauss_jacobi(int num_points, int alpha) {
  if (num_points < 1 || alpha < 0)
    throw std::invalid_argument("gauss_jacobi: needs num_points >= 1 and alpha >= 0, got " +
                                std::to_string(num_points) + " and " + std::to_string(alpha));
  Quadrature rule{1, {}, {}};
  std::vector<long double> roots;
  for (int point = 0; point < num_points; ++point) {
    const long double y = next_root(num_points, alpha, roots);
    const long double slope = jacobi(num_points, alpha, y).slope;
    roots.push_back(y);
    rule.points.push_back(static_cast<double>((1 + y) / 2));
    rule.weights.push_back(static_cast<double>(1 / ((1 - y * y) * slope * slope)));
  }
  return rule;
}

Quadrature simplex_quadrature(int dimension, int degree) {
  if (dimension < 0 || dimension > 4 || degree < 0)
    throw std::invalid_argument("simplex_quadrature: needs 0 <= dimension <= 4 and degree >= 0, got " +
                                std::to_string(dimension) + " and " + std::to_string(degree));
  const int points_per_direction = degree / 2 + 1;
  Quadrature rule{0, {}, {1.0}};
  // Cone over the rule of one dimension less: x_1 = s, the rest (1 - s) times the point below.
  for (int below = 0; below < dimension; ++below) {
    const Quadrature direction = gauss_jacobi(points_per_direction, below);
    Quadrature cone{below + 1, {}, {}};
    for (int i = 0; i < direction.num_points(); ++i)
      for (int q = 0; q < rule.num_points(); ++q) {
        cone.points.push_back(direction.points[i]);
        for (int j = 0; j < below; ++j) cone.points.push_back((1 - direction.points[i]) * rule.points[q * below + j]);
        cone.weights.push_back(direction.weights[i] * rule.weights[q]);
      }
    rule = cone;
  }
  return rule;
}

}  // namespace tentpole
