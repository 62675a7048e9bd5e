#include "host/output/crack_strip.hpp"

#include <gtest/gtest.h>

#include "kernels/element/quadrature.hpp"

namespace tentpole {
namespace {

/// From (0, 0) to (2, 0); damage 0.2 below and 0.6 above everywhere.
CrackStrip strip_between(std::array<double, 2> old_time, std::array<double, 2> new_time) {
  CrackStrip strip;
  strip.dimension = 2;
  strip.end = {{{0, 0, 0}, {2, 0, 0}}};
  strip.old_time = old_time;
  strip.new_time = new_time;
  strip.below = uniform_crack_edge(3, 0.2);
  strip.above = uniform_crack_edge(3, 0.6);
  return strip;
}

void expect_part(const CrackStrip& strip, double time, double begin, double end) {
  const std::optional<StripPart> part = part_at(strip, time);
  ASSERT_TRUE(part.has_value()) << time;
  EXPECT_NEAR(part->begin, begin, 1e-14) << time;
  EXPECT_NEAR(part->end, end, 1e-14) << time;
}

/// The end at 1 rises from 1 to 3.
TEST(CrackStrip, AnswersForThePartBetweenItsFronts) {
  const CrackStrip strip = strip_between({1, 1}, {1, 3});
  EXPECT_FALSE(part_at(strip, 1).has_value());
  expect_part(strip, 2, 0.5, 1);
  expect_part(strip, 1.5, 0.25, 1);
  EXPECT_FALSE(part_at(strip, 3).has_value()) << "a point";
  EXPECT_FALSE(part_at(strip, 3.5).has_value());
}

TEST(CrackStrip, IsCutByBothFronts) {
  const CrackStrip strip = strip_between({0.5, 2.5}, {2.5, 2.5});
  expect_part(strip, 1, 0, 0.25);
  expect_part(strip, 2, 0, 0.75);
  expect_part(strip, 2.5, 0, 1);
}

/// Tents on one edge, one after the other: at every time they cover it once.
TEST(CrackStrip, StripsOfAnEdgeCoverItOnce) {
  const std::array<double, 2> fronts[] = {{0, 0}, {0.7, 0}, {0.7, 1.1}, {1.6, 1.1}, {1.6, 2}, {2, 2}};
  for (double time = 0; time <= 2; time += 0.125) {
    double covered = 0;
    for (int i = 0; i + 1 < 6; ++i)
      if (const auto part = part_at(strip_between(fronts[i], fronts[i + 1]), time)) covered += part->end - part->begin;
    EXPECT_NEAR(covered, 1, 1e-14) << time;
  }
}

TEST(CrackStrip, AVertexAnswersAsElementsDo) {
  CrackStrip strip = strip_between({1, 1}, {2, 2});
  strip.dimension = 1;
  EXPECT_FALSE(part_at(strip, 1).has_value());
  expect_part(strip, 1.5, 0, 1);
  expect_part(strip, 2, 0, 1);
  strip.old_time = {0, 0};
  expect_part(strip, 0, 0, 1);
  EXPECT_EQ(strip.measure(), 1);
}

TEST(CrackStrip, DamageIsLinearInTimeAlongItsLines) {
  const CrackStrip strip = strip_between({1, 1}, {1, 3});
  const StripPart part = part_at(strip, 2).value();
  const CrackEdgeState state = damage_at(strip, part, 2);
  const Quadrature rule = gauss_jacobi(3, 0);
  for (int point = 0; point < 3; ++point) {
    const double fraction = 0.5 + 0.5 * rule.points[point];  // the new front is at 1 + 2 fraction
    EXPECT_NEAR(state.damage[point], 0.2 + 0.4 / (2 * fraction), 1e-14);
  }
}

TEST(CrackStrip, DamageFollowsThePolynomialAlongTheEdge) {
  CrackStrip strip = strip_between({0, 0}, {1, 1});
  const Quadrature rule = gauss_jacobi(3, 0);
  for (int point = 0; point < 3; ++point) {
    strip.below.damage[point] = 0.1 * rule.points[point];
    strip.above.damage[point] = 0.5 * rule.points[point];
  }
  const CrackEdgeState state = damage_at(strip, {0.25, 0.75}, 0.5);
  for (int point = 0; point < 3; ++point)
    EXPECT_NEAR(state.damage[point], 0.3 * (0.25 + 0.5 * rule.points[point]), 1e-14);
}

TEST(CrackStrip, KnowsItsRangeAndPlace) {
  const CrackStrip strip = strip_between({1, 0.5}, {1, 3});
  EXPECT_EQ(strip.time_min(), 0.5);
  EXPECT_EQ(strip.time_max(), 3);
  EXPECT_EQ(strip.measure(), 2);
  EXPECT_EQ(strip.position(0.25), (std::array<double, 3>{0.5, 0, 0}));
}

}  // namespace
}  // namespace tentpole
