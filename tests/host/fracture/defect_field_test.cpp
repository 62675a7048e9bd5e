#include "host/fracture/defect_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/fracture/kolmogorov_smirnov.hpp"

namespace tentpole {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double weak = 400e6;  // rank 1.6e-4

/// The defects of the thesis' bar, 1 mm x 0.2 mm: about 320 of 2 million are weaker than 400 MPa.
const StrengthDistribution strengths =
    StrengthDistribution::truncated_normal(2e9, tail_standard_deviation(2e9, 400e6, 2e-4), 220e6, 4e9);
constexpr double density = 1e13;

DefectField thesis_field(std::uint64_t seed = 1) {
  return DefectField(2, density, strengths, seed);
}

bool operator==(const Defect& a, const Defect& b) {
  return a.id == b.id && a.position == b.position && a.strength == b.strength;
}

bool are_equal(const std::vector<Defect>& a, const std::vector<Defect>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Defect& x, const Defect& y) { return x == y; });
}

std::vector<Defect> sorted(std::vector<Defect> defects) {
  std::sort(defects.begin(), defects.end(), [](const Defect& a, const Defect& b) { return a.id < b.id; });
  return defects;
}

/// Number of defects in each of n intervals of [0, 1): intervals are queried from the last to the first.
std::vector<int> counts_on_a_line(const DefectField& field, int n, double strongest) {
  std::vector<int> counts(n);
  for (int i = n - 1; i >= 0; --i)
    counts[i] = static_cast<int>(field.in_box({double(i) / n, 0, 0}, {double(i + 1) / n, 0, 0}, strongest).size());
  return counts;
}

TEST(DefectField, PartsHoldTheDefectsOfTheWholeInAnyOrder) {
  const DefectField field = thesis_field();
  const std::vector<Defect> whole = field.in_box({0, 0, 0}, {1e-3, 2e-4, 0}, weak);
  ASSERT_GT(whole.size(), 250u);
  for (const int n : {3, 17}) {
    std::vector<Defect> parts;
    for (int i = n - 1; i >= 0; --i)
      for (int j = 0; j < n; ++j)
        for (const Defect& defect :
             field.in_box({1e-3 * i / n, 2e-4 * j / n, 0}, {1e-3 * (i + 1) / n, 2e-4 * (j + 1) / n, 0}, weak))
          parts.push_back(defect);
    EXPECT_TRUE(are_equal(sorted(parts), whole)) << n;
  }
  EXPECT_TRUE(are_equal(sorted(whole), whole));
  EXPECT_TRUE(are_equal(thesis_field().in_box({0, 0, 0}, {1e-3, 2e-4, 0}, weak), whole));
}

TEST(DefectField, TrianglesPartitionTheDefectsOfTheirUnion) {
  const DefectField field = thesis_field();
  // a fan around an inner point, in both orientations
  const std::vector<Point> rim{{0, 0, 0}, {1e-3, 0, 0}, {1e-3, 2e-4, 0}, {4e-4, 2e-4, 0}, {0, 2e-4, 0}};
  const Point middle{3.1e-4, 0.9e-4, 0};
  std::vector<Defect> parts;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    std::vector<Point> corners{middle, rim[i], rim[(i + 1) % rim.size()]};
    if (i % 2) std::swap(corners[1], corners[2]);
    for (const Defect& defect : field.in_simplex(corners, weak)) parts.push_back(defect);
  }
  EXPECT_TRUE(are_equal(sorted(parts), field.in_box({0, 0, 0}, {1e-3, 2e-4, 0}, weak)));
}

TEST(DefectField, LowerCutOffKeepsTheWeakerDefectsAsTheyAre) {
  const DefectField field = thesis_field();
  const Point low{0, 0, 0}, high{1e-3, 2e-4, 0};
  const std::vector<Defect> many = field.in_box(low, high, 500e6);
  for (double cut_off = 219e6; cut_off < 500e6; cut_off += 2e6) {  // across the ends of several layers
    std::vector<Defect> weaker;
    std::copy_if(many.begin(), many.end(), std::back_inserter(weaker),
                 [&](const Defect& defect) { return defect.strength <= cut_off; });
    EXPECT_TRUE(are_equal(field.in_box(low, high, cut_off), weaker)) << cut_off;
  }
  EXPECT_TRUE(field.in_box(low, high, 219e6).empty());
}

TEST(DefectField, IdsAreUniqueAndSeedsGiveOtherDefects) {
  const std::vector<Defect> first = thesis_field(1).in_box({0, 0, 0}, {1e-3, 2e-4, 0}, weak);
  const std::vector<Defect> second = thesis_field(2).in_box({0, 0, 0}, {1e-3, 2e-4, 0}, weak);
  std::set<DefectId> ids;
  std::set<double> abscissas;
  for (const auto* defects : {&first, &second})
    for (const Defect& defect : *defects) abscissas.insert(defect.position[0]);
  for (const Defect& defect : first) ids.insert(defect.id);
  EXPECT_EQ(ids.size(), first.size());
  EXPECT_EQ(abscissas.size(), first.size() + second.size());
}

TEST(DefectField, ReachesBeyondTheOrigin) {
  const DefectField field = thesis_field();
  const std::vector<Defect> defects = field.in_box({-1e-3, -2e-4, 0}, {1e-3, 2e-4, 0}, weak);
  const auto left = std::count_if(defects.begin(), defects.end(), [](const Defect& d) { return d.position[0] < 0; });
  EXPECT_GT(left, static_cast<int>(defects.size()) / 3);
  EXPECT_LT(left, 2 * static_cast<int>(defects.size()) / 3);
}

TEST(DefectField, CountsArePoissonOnALine) {
  for (const double cut_off : {0.3, 1.0, 2.5}) {  // ranks 0.6 %, 26 % and nearly 1
    const StrengthDistribution weibull = StrengthDistribution::weibull(0.1, 2, 1.5, infinity);
    const DefectField field(1, 2e4 / weibull.probability(cut_off), weibull, 3);
    const std::vector<int> counts = counts_on_a_line(field, 7777, cut_off);
    const double mean = field.mean_number(1.0 / 7777, cut_off);
    double sum = 0;
    for (const int count : counts) sum += count;
    EXPECT_NEAR(mean * 7777, 2e4, 1e-8);
    EXPECT_NEAR(sum, 2e4, 3.3 * std::sqrt(2e4)) << cut_off;
    EXPECT_LT(std::abs(dispersion_deviation(counts, mean)), 3.3) << cut_off;
  }
}

TEST(DefectField, CountsArePoissonInThePlaneAndIndependentOfTheNeighbours) {
  const int n = 120;
  const double size = 1e-2 / n;
  const DefectField field = thesis_field(4);
  const double mean = field.mean_number(size * size, weak);
  std::vector<int> counts;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      counts.push_back(
          static_cast<int>(field.in_box({size * i, size * j, 0}, {size * (i + 1), size * (j + 1), 0}, weak).size()));
  double sum = 0, product = 0;
  for (const int count : counts) sum += count;
  EXPECT_NEAR(sum, mean * n * n, 3.3 * std::sqrt(mean * n * n));
  EXPECT_LT(std::abs(dispersion_deviation(counts, mean)), 3.3);
  for (std::size_t i = 0; i + n < counts.size(); ++i) product += (counts[i] - mean) * (counts[i + n] - mean);
  EXPECT_LT(std::abs(product), 3.3 * mean * std::sqrt(n * (n - 1)));
}

TEST(DefectField, StrengthsAndPositionsHaveTheirDistributions) {
  const double length = 8e-3;
  const std::vector<Defect> defects = thesis_field(5).in_box({0, 0, 0}, {length, length, 0}, weak);
  ASSERT_GT(defects.size(), 50000u);
  std::vector<double> strength, x, y;
  for (const Defect& defect : defects) {
    strength.push_back(defect.strength);
    x.push_back(defect.position[0] / length);
    y.push_back(defect.position[1] / length);
  }
  const auto truncated = [](double s) { return strengths.probability(s) / strengths.probability(weak); };
  const auto uniform = [](double fraction) { return fraction; };
  EXPECT_LT(kolmogorov_statistic(strength, truncated), critical_kolmogorov);
  EXPECT_GT(kolmogorov_statistic(strength, [&](double s) { return truncated(s * 0.995); }), critical_kolmogorov);
  EXPECT_LT(kolmogorov_statistic(x, uniform), critical_kolmogorov);
  EXPECT_LT(kolmogorov_statistic(y, uniform), critical_kolmogorov);
}

TEST(DefectField, PositionsHaveNoGridWithinTheTriangle) {
  const std::vector<Point> corners{{0, 0, 0}, {8e-3, 1e-3, 0}, {2e-3, 7e-3, 0}};
  const double area = (8e-3 * 7e-3 - 2e-3 * 1e-3) / 2;
  const DefectField field = thesis_field(6);
  const std::vector<Defect> defects = field.in_simplex(corners, weak);
  const double mean = field.mean_number(area, weak);
  EXPECT_NEAR(static_cast<double>(defects.size()), mean, 3.3 * std::sqrt(mean));
  std::vector<double> opposite;  // barycentric coordinate of corner 0: its distribution function is 1 - (1 - b)^2
  for (const Defect& defect : defects) {
    const double x = defect.position[0], y = defect.position[1];
    opposite.push_back(1 - ((x * 7e-3 - y * 2e-3) + (y * 8e-3 - x * 1e-3)) / (2 * area));
  }
  EXPECT_LT(kolmogorov_statistic(opposite, [](double b) { return 1 - (1 - b) * (1 - b); }), critical_kolmogorov);
}

TEST(DefectField, WithoutDensityIsEmpty) {
  EXPECT_TRUE(DefectField(2, 0, strengths, 1).in_box({0, 0, 0}, {1, 1, 0}, infinity).empty());
}

TEST(DefectField, IntervalIsClosedAndTakesItsEndsInAnyOrder) {
  const DefectField field(1, 1e4, StrengthDistribution::weibull(0, 2, 1, infinity), 7);
  const std::vector<Point> forward{{0.2, 0, 0}, {0.4, 0, 0}}, backward{forward[1], forward[0]};
  const std::vector<Defect> defects = field.in_simplex(forward, infinity);
  EXPECT_NEAR(static_cast<double>(defects.size()), 2000, 3.3 * std::sqrt(2000.0));
  EXPECT_TRUE(are_equal(field.in_simplex(backward, infinity), defects));
  const std::vector<Point> point(2, defects[5].position);
  EXPECT_EQ(field.in_simplex(point, infinity).size(), 1u);
}

}  // namespace
}  // namespace tentpole
