#include "host/fracture/crack_edge_state.hpp"

#include <algorithm>
#include <cassert>
#include <span>
#include <vector>

#include "kernels/element/quadrature.hpp"

namespace tentpole {
namespace {

/// Gauss rule on [0, 1], weights sum to 1.
const Quadrature& gauss_rule(int num_points) {
  static const std::vector<Quadrature> rules = [] {
    std::vector<Quadrature> all(1);
    for (int n = 1; n <= max_degree + 1; ++n) all.push_back(gauss_jacobi(n, 0));
    return all;
  }();
  assert(num_points >= 1 && num_points <= max_degree + 1 && "an edge has k + 1 points");
  return rules[num_points];
}

/// Value at x of the polynomial through the values at the rule's points (Lagrange).
double interpolate(const Quadrature& rule, std::span<const double> values, double x) {
  double sum = 0;
  for (int i = 0; i < rule.num_points(); ++i) {
    double shape = 1;
    for (int j = 0; j < rule.num_points(); ++j)
      if (j != i) shape *= (x - rule.points[j]) / (rule.points[i] - rule.points[j]);
    sum += shape * values[i];
  }
  return sum;
}

std::span<const double> damage_of(const CrackEdgeState& edge) {
  return std::span(edge.damage).first(edge.num_points);
}

}  // namespace

CrackEdgeState uniform_crack_edge(int num_points, double damage) {
  CrackEdgeState edge;
  edge.num_points = num_points;
  std::fill_n(edge.damage.begin(), num_points, damage);
  return edge;
}

CrackEdgeState restrict_to_part(const CrackEdgeState& edge, double begin, double end) {
  const Quadrature& rule = gauss_rule(edge.num_points);
  CrackEdgeState part;
  part.num_points = edge.num_points;
  part.effective_traction = edge.effective_traction;
  for (int point = 0; point < edge.num_points; ++point) {
    const double x = begin + (end - begin) * rule.points[point];
    part.damage[point] = std::clamp(interpolate(rule, edge.damage, x), 0.0, 1.0);
    part.gap[point] = interpolate(rule, edge.gap, x);
  }
  return part;
}

double mean_damage(const CrackEdgeState& edge) {
  const Quadrature& rule = gauss_rule(edge.num_points);
  double mean = 0;
  for (int point = 0; point < edge.num_points; ++point) mean += rule.weights[point] * edge.damage[point];
  return mean;
}

double smallest_damage(const CrackEdgeState& edge) {
  return std::ranges::min(damage_of(edge));
}

double largest_damage(const CrackEdgeState& edge) {
  return std::ranges::max(damage_of(edge));
}

double failed_fraction(const CrackEdgeState& edge) {
  const Quadrature& rule = gauss_rule(edge.num_points);
  double fraction = 0;
  for (int point = 0; point < edge.num_points; ++point)
    if (edge.damage[point] >= failed_damage) fraction += rule.weights[point];
  return fraction;
}

bool has_failed(const CrackEdgeState& edge) {
  return smallest_damage(edge) >= failed_damage;
}

bool is_active(const CrackEdgeState& edge, const FractureLaw& law) {
  return !has_failed(edge) && target_damage(law, traction_margin * edge.effective_traction) > smallest_damage(edge);
}

}  // namespace tentpole
