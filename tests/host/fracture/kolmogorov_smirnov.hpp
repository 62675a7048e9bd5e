#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace tentpole {

/// sqrt(n) times the largest distance between the empirical distribution of a sample and the distribution function.
/// Kolmogorov: above 1.95 in 0.1 % of all samples, if they have that distribution.
template <class Distribution>
double kolmogorov_statistic(std::vector<double> sample, const Distribution& distribution) {
  std::sort(sample.begin(), sample.end());
  const auto size = static_cast<double>(sample.size());
  double distance = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double expected = distribution(sample[i]), rank = static_cast<double>(i);
    distance = std::max({distance, expected - rank / size, (rank + 1) / size - expected});
  }
  return std::sqrt(size) * distance;
}

inline constexpr double critical_kolmogorov = 1.95;

/// For counts that should be Poisson with the same mean: (index of dispersion - its mean) over its standard deviation;
/// about standard normal for many counts.
inline double dispersion_deviation(const std::vector<int>& counts, double mean) {
  double sum = 0;
  for (const int count : counts) sum += (count - mean) * (count - mean) / mean;
  const auto size = static_cast<double>(counts.size());
  return (sum - size) / std::sqrt(size * (2 + 1 / mean));
}

}  // namespace tentpole
