#include "host/fracture/strength_distribution.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "host/fracture/random_numbers.hpp"
#include "host/fracture/standard_normal.hpp"
#include "tests/host/fracture/kolmogorov_smirnov.hpp"

namespace tentpole {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The defects of the thesis' bar (2.4.1), with a maximum that the thesis does not name.
NucleationSettings thesis_bar() {
  NucleationSettings settings;
  settings.model = NucleationModel::field;
  settings.mean = 2e9;
  settings.minimum = 220e6;
  settings.maximum = 4e9;
  settings.tail_strength = 400e6;
  settings.tail_probability = 2e-4;
  return settings;
}

std::vector<double> draw(const StrengthDistribution& distribution, int size, std::uint64_t seed) {
  std::vector<double> sample;
  for (int i = 0; i < size; ++i)
    sample.push_back(distribution.strength(
        uniform_numbers({seed, RandomPurpose::defect_tests}, {static_cast<std::uint64_t>(i)})[0]));
  return sample;
}

TEST(TailStandardDeviation, BelongsToTheNormalDistributionBeforeTruncation) {
  const double sigma = tail_standard_deviation(2e9, 400e6, 2e-4);
  EXPECT_NEAR(sigma, 451966702.13253030, 1e-5);
  EXPECT_NEAR(normal_probability((400e6 - 2e9) / sigma), 2e-4, 1e-17);
}

TEST(TruncatedNormal, ThesisBarHasItsMinimumAndATailSmallerThanBeforeTruncation) {
  const StrengthDistribution bar = StrengthDistribution::from_settings(thesis_bar());
  EXPECT_EQ(bar.probability(219e6), 0);
  EXPECT_EQ(bar.probability(4e9), 1);
  EXPECT_NEAR(bar.probability(400e6), 1.5898420100396680e-4, 1e-16);
  EXPECT_NEAR(bar.strength(0), 220e6, 1e-3);
  EXPECT_GE(bar.strength(0), 220e6);
  EXPECT_NEAR(bar.strength(1), 4e9, 1e-2);
  EXPECT_LE(bar.strength(1), 4e9);
}

TEST(TruncatedNormal, StrengthInvertsProbability) {
  const StrengthDistribution bar = StrengthDistribution::from_settings(thesis_bar());
  for (double strength = 221e6; strength < 4e9; strength += 31e6)
    EXPECT_NEAR(bar.strength(bar.probability(strength)), strength, 1e-9 * strength);
}

TEST(TruncatedNormal, WithoutTruncationIsTheNormalDistribution) {
  const StrengthDistribution wide = StrengthDistribution::truncated_normal(5, 2, -infinity, infinity);
  EXPECT_NEAR(wide.probability(3), normal_probability(-1), 1e-16);
  EXPECT_NEAR(wide.strength(0.975), 5 + 2 * 1.9599639845400538556, 1e-13);
}

TEST(TruncatedNormal, SampleHasTheDistributionAndTheTestCanTellOthers) {
  const StrengthDistribution cut = StrengthDistribution::truncated_normal(2, 1, 0.5, 4);
  const std::vector<double> sample = draw(cut, 20000, 11);
  const auto statistic = [&](const StrengthDistribution& distribution) {
    return kolmogorov_statistic(sample, [&](double s) { return distribution.probability(s); });
  };
  EXPECT_LT(statistic(cut), critical_kolmogorov);
  EXPECT_GT(statistic(StrengthDistribution::truncated_normal(2, 1.25, 0.5, 4)), critical_kolmogorov);
  EXPECT_GT(statistic(StrengthDistribution::truncated_normal(2.05, 1, 0.5, 4)), critical_kolmogorov);
  EXPECT_GT(statistic(StrengthDistribution::truncated_normal(2, 1, -infinity, infinity)), critical_kolmogorov);
}

TEST(Weibull, HasTheValuesOfItsFormula) {
  const StrengthDistribution weibull = StrengthDistribution::weibull(100, 3, 50, infinity);
  EXPECT_EQ(weibull.probability(100), 0);
  EXPECT_NEAR(weibull.probability(150), 1 - std::exp(-1), 1e-16);
  EXPECT_NEAR(weibull.strength(1 - std::exp(-8)), 200, 1e-10);
  // far down the tail, ((s - s_min) / s_0)^m without cancellation
  EXPECT_NEAR(weibull.probability(100.05) / 1e-9, 1, 1e-9);
  EXPECT_NEAR(weibull.strength(1e-30), 100 + 50e-10, 1e-12);
}

TEST(Weibull, TruncatedAboveReachesOneThere) {
  const StrengthDistribution cut = StrengthDistribution::weibull(100, 3, 50, 150);
  EXPECT_EQ(cut.probability(150), 1);
  EXPECT_NEAR(cut.strength(1), 150, 1e-10);
  EXPECT_NEAR(cut.probability(125), (1 - std::exp(-0.125)) / (1 - std::exp(-1)), 1e-15);
}

TEST(Weibull, SampleHasTheDistributionAndTheTestCanTellOthers) {
  const StrengthDistribution weibull = StrengthDistribution::weibull(1, 8, 5, infinity);
  const std::vector<double> sample = draw(weibull, 20000, 12);
  const auto statistic = [&](double minimum, double modulus) {
    const StrengthDistribution other = StrengthDistribution::weibull(minimum, modulus, 5, infinity);
    return kolmogorov_statistic(sample, [&](double s) { return other.probability(s); });
  };
  EXPECT_LT(statistic(1, 8), critical_kolmogorov);
  EXPECT_GT(statistic(1, 8.5), critical_kolmogorov);
  EXPECT_GT(statistic(0.95, 8), critical_kolmogorov);
}

TEST(FromSettings, TakesTheWeibullKeys) {
  NucleationSettings settings;
  settings.distribution = StrengthLaw::weibull;
  settings.minimum = 100;
  settings.weibull_modulus = 3;
  settings.weibull_scale = 50;
  EXPECT_NEAR(StrengthDistribution::from_settings(settings).probability(150), 1 - std::exp(-1), 1e-16);
}

}  // namespace
}  // namespace tentpole
