#include "host/front/progress_rule.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

TEST(FrontSimplex, MeasuresARightTriangle) {
  const FrontSimplex cell{2, {{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}}, {1, 1.6, 2.2}};
  EXPECT_DOUBLE_EQ(signed_measure(cell), 6);
  EXPECT_DOUBLE_EQ(longest_edge(cell), 5);
  EXPECT_DOUBLE_EQ(altitude(cell, 0), 2.4);
  EXPECT_DOUBLE_EQ(altitude(cell, 1), 3);
  EXPECT_DOUBLE_EQ(shortest_altitude(cell), 2.4);
  EXPECT_DOUBLE_EQ(smallest_angle_sine(cell), 0.6);
  EXPECT_DOUBLE_EQ(shape_defect(cell), 50 / (4 * std::sqrt(3.0) * 6));
  EXPECT_NEAR(time_gradient(cell)[0], 0.2, 1e-15);
  EXPECT_NEAR(time_gradient(cell)[1], 0.3, 1e-15);
  EXPECT_NEAR(time_at(cell, {-1, 2, 0}), 1.4, 1e-15);
}

TEST(FrontSimplex, CallsTheEquilateralTrianglePerfectAndInvertedOnesHopeless) {
  FrontSimplex cell{2, {{{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}}}, {}};
  EXPECT_NEAR(shape_defect(cell), 1, 1e-15);
  std::swap(cell.position[0], cell.position[1]);
  EXPECT_TRUE(std::isinf(shape_defect(cell)));
}

TEST(ProgressRule, LimitsAnObtuseTriangleByAltitudeAndBySineOfTheAngle) {
  FrontSimplex cell{2, {{{-std::sqrt(0.75), 0, 0}, {std::sqrt(0.75), 0, 0}, {0, 0.5, 0}}}, {0, 0, 0}};  // 120 degrees
  EXPECT_DOUBLE_EQ(latest_corner_time(cell, 2, 0.25), 0.25 * 0.5);
  EXPECT_DOUBLE_EQ(latest_corner_time(cell, 0, 0.25), 0.25 * 0.7 * std::sqrt(0.75));
  const double slope = 0.03;
  cell.time = {0, 2 * std::sqrt(0.75) * slope, 0};
  EXPECT_DOUBLE_EQ(latest_corner_time(cell, 2, 0.25),
                   std::sqrt(0.75) * slope + 0.5 * std::sqrt(0.25 * 0.25 - slope * slope));
}

TEST(ProgressRule, AdmitsACellExactlyUpToItsLimits) {
  FrontSimplex cell{2, {{{0, 0, 0}, {1, 0, 0}, {0.4, 0.8, 0}}}, {0.1, 0, 0}};
  for (int corner = 0; corner < 3; ++corner) {
    FrontSimplex raised = cell;
    const double latest = latest_corner_time(cell, corner, 0.5);
    raised.time[corner] = latest;
    EXPECT_TRUE(may_be_on_front(raised, 0.5));
    raised.time[corner] = latest + 1e-6;
    EXPECT_FALSE(may_be_on_front(raised, 0.5));
  }
  const FrontSimplex interval{1, {{{2, 0, 0}, {1, 0, 0}}}, {0, 0.5}};
  EXPECT_DOUBLE_EQ(latest_corner_time(interval, 0, 0.25), 0.75);
  EXPECT_DOUBLE_EQ(edge_limit_use(interval, 0.25), 2);
  EXPECT_FALSE(may_be_on_front(interval, 0.25));
}

}  // namespace
}  // namespace tentpole
