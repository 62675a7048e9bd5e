#include "host/fracture/standard_normal.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace tentpole {
namespace {

/// For 0 < probability <= 0.5.
double lower_quantile(double probability) {
  const double t = std::sqrt(-2 * std::log(probability));
  const double numerator = 2.515517 + t * (0.802853 + t * 0.010328);
  const double denominator = 1 + t * (1.432788 + t * (0.189269 + t * 0.001308));
  double x = numerator / denominator - t;
  for (int step = 0; step < 3; ++step) {
    const double density = std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
    const double newton = (normal_probability(x) - probability) / density;
    x -= newton / (1 + x * newton / 2);
  }
  return x;
}

}  // namespace

double normal_probability(double x) {
  return std::erfc(-x / std::numbers::sqrt2) / 2;
}

double normal_quantile(double probability) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(probability > 0)) return -infinity;
  if (!(probability < 1)) return infinity;
  return probability <= 0.5 ? lower_quantile(probability) : -lower_quantile(1 - probability);
}

}  // namespace tentpole
