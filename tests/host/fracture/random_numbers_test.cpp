#include "host/fracture/random_numbers.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/fracture/kolmogorov_smirnov.hpp"

namespace tentpole {
namespace {

TEST(UniformNumbers, AreThoseOfPhilox4x64) {
  // words of an independent implementation (numpy.random.Philox), key (42, 1), counter (5, 7, 11, 13)
  const auto numbers = uniform_numbers({42, RandomPurpose::defect_field}, {5, 7, 11, 13});
  const std::array<double, 4> expected{0.5167612382166119, 0.4501545652972442, 0.35141796652540347, 0.8581510275899328};
  EXPECT_EQ(numbers, expected);
}

TEST(UniformNumbers, AreUniformAndDifferForEveryKeyAndCounter) {
  std::vector<double> sample;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    for (const double number : uniform_numbers({i % 10, RandomPurpose::defect_field}, {i / 10, 3, 0, 0}))
      sample.push_back(number);
    for (const double number : uniform_numbers({1, RandomPurpose::defect_tests}, {0, 0, i, 0}))
      sample.push_back(number);
  }
  EXPECT_LT(kolmogorov_statistic(sample, [](double x) { return x; }), critical_kolmogorov);
  std::sort(sample.begin(), sample.end());
  EXPECT_EQ(std::adjacent_find(sample.begin(), sample.end()), sample.end());
}

TEST(PoissonNumber, InvertsTheDistribution) {
  // P(N <= 0) = exp(-2) = 0.1353, P(N <= 1) = 0.4060, P(N <= 2) = 0.6767
  EXPECT_EQ(poisson_number(2, 0.1353), 0);
  EXPECT_EQ(poisson_number(2, 0.1354), 1);
  EXPECT_EQ(poisson_number(2, 0.4060), 1);
  EXPECT_EQ(poisson_number(2, 0.4061), 2);
  EXPECT_EQ(poisson_number(2, 0.6768), 3);
  EXPECT_EQ(poisson_number(0, 0.999), 0);
}

TEST(PoissonNumber, EndsForTheLargestUniformNumber) {
  EXPECT_LT(poisson_number(largest_poisson_mean, 1 - std::ldexp(1.0, -53)), 200);
}

TEST(PoissonNumber, HasMeanAndVarianceOfAPoissonDistribution) {
  for (const double mean : {0.1, 2.0, largest_poisson_mean}) {
    std::vector<int> counts;
    double sum = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
      counts.push_back(
          static_cast<int>(poisson_number(mean, uniform_numbers({5, RandomPurpose::defect_tests}, {i})[0])));
      sum += counts.back();
    }
    EXPECT_NEAR(sum / 20000, mean, 3.3 * std::sqrt(mean / 20000));
    EXPECT_LT(std::abs(dispersion_deviation(counts, mean)), 3.3);
  }
}

}  // namespace
}  // namespace tentpole
