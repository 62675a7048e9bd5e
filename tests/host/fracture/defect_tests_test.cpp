#include "host/fracture/defect_tests.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/fracture/kolmogorov_smirnov.hpp"

namespace tentpole {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const StrengthDistribution strengths = StrengthDistribution::truncated_normal(2, 1, 0.5, 4);
const std::vector<Point> triangle{{0, 0, 0}, {2, 0.5, 0}, {0.5, 1.5, 0}};  // area 1.375
const std::vector<Point> interval{{3, 0, 0}, {1, 0, 0}};

std::vector<DefectTest> tests_of(std::uint64_t seed, std::int64_t serial, std::int64_t patch, double density = 10,
                                 double strongest = infinity) {
  return draw_defect_tests({seed, serial, patch}, triangle, density, strengths, strongest);
}

bool are_equal(const std::vector<DefectTest>& a, const std::vector<DefectTest>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].position != b[i].position || a[i].strength != b[i].strength) return false;
  return true;
}

TEST(DrawDefectTests, DependsOnSeedCellAndPatchOnly) {
  const std::vector<DefectTest> first = tests_of(1, 2, 3);
  ASSERT_FALSE(first.empty());
  EXPECT_FALSE(are_equal(tests_of(2, 2, 3), first));
  EXPECT_FALSE(are_equal(tests_of(1, 3, 3), first));
  EXPECT_FALSE(are_equal(tests_of(1, 2, 4), first));
  EXPECT_FALSE(are_equal(tests_of(1, 3, 2), first));
  EXPECT_TRUE(are_equal(tests_of(1, 2, 3), first));
}

TEST(DrawDefectTests, NumberIsPoissonWithMeanDensityTimesMeasure) {
  for (const double density : {0.5, 10.0, 100.0}) {  // the last mean is drawn in parts
    std::vector<int> counts;
    double sum = 0;
    for (int cell = 0; cell < 5000; ++cell) {
      counts.push_back(static_cast<int>(tests_of(1, cell, cell / 7, density).size()));
      sum += counts.back();
    }
    const double mean = 1.375 * density;
    EXPECT_NEAR(sum / 5000, mean, 3.3 * std::sqrt(mean / 5000));
    EXPECT_LT(std::abs(dispersion_deviation(counts, mean)), 3.3);
  }
}

TEST(DrawDefectTests, PointsAreUniformInTheTriangleAndStrengthsHaveTheirDistribution) {
  std::vector<double> first, second, strength;
  for (int patch = 0; patch < 1500; ++patch)
    for (const DefectTest& test : tests_of(4, 1, patch)) {
      const double x = test.position[0], y = test.position[1], doubled_area = 2.75;
      first.push_back((x * 1.5 - y * 0.5) / doubled_area);
      second.push_back((y * 2 - x * 0.5) / doubled_area);
      strength.push_back(test.strength);
      EXPECT_GE(std::min({first.back(), second.back(), 1 - first.back() - second.back()}), 0);
    }
  ASSERT_GT(first.size(), 19000u);
  const auto of_barycentric = [](double b) { return 1 - (1 - b) * (1 - b); };
  EXPECT_LT(kolmogorov_statistic(first, of_barycentric), critical_kolmogorov);
  EXPECT_LT(kolmogorov_statistic(second, of_barycentric), critical_kolmogorov);
  EXPECT_LT(kolmogorov_statistic(strength, [](double s) { return strengths.probability(s); }), critical_kolmogorov);
}

TEST(DrawDefectTests, CutOffKeepsNumberAndDistributionOfTheWeak) {
  const double cut_off = 1.2, weak = strengths.probability(cut_off);
  std::vector<double> strength;
  for (int patch = 0; patch < 2000; ++patch)
    for (const DefectTest& test : tests_of(5, 1, patch, 50, cut_off)) strength.push_back(test.strength);
  const double mean = 2000 * 50 * 1.375 * weak;
  EXPECT_NEAR(static_cast<double>(strength.size()), mean, 3.3 * std::sqrt(mean));
  EXPECT_LT(kolmogorov_statistic(strength, [&](double s) { return strengths.probability(s) / weak; }),
            critical_kolmogorov);
  EXPECT_TRUE(tests_of(5, 1, 1, 1e6, 0.49).empty());
}

TEST(DrawDefectTests, IntervalIsTestedAlongItsLength) {
  std::vector<double> fraction;
  for (int patch = 0; patch < 1000; ++patch)
    for (const DefectTest& test : draw_defect_tests({6, 1, patch}, interval, 5, strengths, infinity))
      fraction.push_back((test.position[0] - 1) / 2);
  EXPECT_NEAR(static_cast<double>(fraction.size()), 1e4, 3.3 * std::sqrt(1e4));
  EXPECT_LT(kolmogorov_statistic(fraction, [](double x) { return x; }), critical_kolmogorov);
}

}  // namespace
}  // namespace tentpole
