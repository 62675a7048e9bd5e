#include "host/march/front_report.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/host/march/unit_bar.hpp"
#include "tests/host/run/solved_run.hpp"

// Fragments of a bar that a failed surface at x = 1 cuts, and whose parts fly apart: nothing but rigid motion.
namespace tentpole {
namespace {

constexpr double slow = -0.125, fast = 0.25;

RunSummary flying_bar(int dimension, const std::string& surface) {
  testing::CaseText text = testing::unit_bar(dimension, 2, 0.25, 0.5);
  text.rest = testing::bar_sides(dimension, "normal_traction = \"0\"", "normal_traction = \"0\"") +
              "[initial]\nvelocity = [\"x < 1 ? -0.125 : 0.25\"" + (dimension == 2 ? ", \"0\"]\n" : "]\n") +
              testing::fracture_section({.threshold = 1e3, .strength = 2e3, .relaxation_time = 100}) + surface;
  return testing::solve(text.text()).summary;
}

class Fragments : public ::testing::TestWithParam<int> {};

TEST_P(Fragments, OfACutBarHaveTheirMassesAndVelocities) {
  const int dimension = GetParam();
  const double width = dimension == 2 ? testing::bar_width : 1;
  const RunSummary summary = flying_bar(dimension, testing::crack_across(dimension, 1, 1));
  ASSERT_EQ(summary.fracture.fragments.size(), 2u);
  EXPECT_TRUE(summary.fracture.spalled());
  for (const RunSummary::Fragment& fragment : summary.fracture.fragments) {
    const bool is_left = fragment.mean_velocity[0] < 0;
    EXPECT_NEAR(fragment.size, (is_left ? 1 : 3) * width, 1e-12);
    EXPECT_NEAR(fragment.mass, (is_left ? 1 : 3) * width, 1e-12);
    EXPECT_NEAR(fragment.mean_velocity[0], is_left ? slow : fast, 1e-11);
    EXPECT_NEAR(fragment.mean_velocity[1], 0, 1e-11);
  }
  EXPECT_NE(summary.fracture.fragments[0].mean_velocity[0] < 0, summary.fracture.fragments[1].mean_velocity[0] < 0);
  EXPECT_NEAR(summary.fracture.crack_length, width, 1e-12);
  EXPECT_NEAR(summary.energy.kinetic, summary.energy.initial, 1e-12);
}

TEST_P(Fragments, AreNotMadeByASurfaceThatHolds) {
  const RunSummary summary = flying_bar(GetParam(), testing::crack_across(GetParam(), 1, 0.9));
  ASSERT_EQ(summary.fracture.fragments.size(), 1u);
  const double width = GetParam() == 2 ? testing::bar_width : 1;
  EXPECT_NEAR(summary.fracture.fragments[0].mass, 4 * width, 1e-12);
  EXPECT_NEAR(summary.fracture.fragments[0].mean_velocity[0], (slow + 3 * fast) / 4, 1e-10) << "momentum is conserved";
  EXPECT_EQ(summary.fracture.crack_length, 0);
}

TEST(Fragments, AreNotMadeByACrackThatEndsInside) {
  const RunSummary summary = flying_bar(2, "[[fracture.crack]]\npoints = [[1.0, 0.0], [1.0, 0.25]]\ndamage = 1.0\n");
  EXPECT_EQ(summary.fracture.fragments.size(), 1u);
  EXPECT_FALSE(summary.fracture.spalled());
  EXPECT_NEAR(summary.fracture.crack_length, 0.25, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, Fragments, ::testing::Values(1, 2));

}  // namespace
}  // namespace tentpole
