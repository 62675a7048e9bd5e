#include "bench/checked_answer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace tentpole {

double relative_difference(std::span<const double> computed, std::span<const double> expected) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (computed.size() != expected.size()) return infinity;
  double difference = 0, scale = 0;
  for (std::size_t entry = 0; entry < expected.size(); ++entry) {
    if (!std::isfinite(computed[entry]) || !std::isfinite(expected[entry])) return infinity;
    difference = std::max(difference, std::abs(computed[entry] - expected[entry]));
    scale = std::max(scale, std::abs(expected[entry]));
  }
  return difference > 0 ? difference / scale : 0;
}

double require_answer(const std::string& what, double error, double limit) {
  if (error <= limit) return error;
  std::fprintf(stderr, "%s: wrong answer, error %.1e (limit %.1e)\n", what.c_str(), error, limit);
  std::exit(1);
}

}  // namespace tentpole
