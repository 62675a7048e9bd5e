#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "kernels/fracture/damage_law.hpp"
#include "tests/host/march/unit_bar.hpp"
#include "tests/host/run/solved_run.hpp"

// A fracture surface across a bar at mid-span. Damage does not change the waves that meet there until they return from
// the ends, so the intact traction is known, and with it damage from an ordinary differential equation.
namespace tentpole {
namespace {

using testing::SolvedRun;

constexpr double speed = 0.5, ramp = 2, arrival = 0.5 * testing::bar_length;  // rho = c_p = Z = tau = 1
constexpr FractureLaw law{0.748, 0.998, 1, 10, 1, 0};

/// Damage at time `end` under the two waves, by the midpoint rule in q = exp(-a D).
double damage_of_the_law(double end) {
  constexpr int num_steps = 400000;
  const double step = end / num_steps;
  double q = 1;
  for (int i = 0; i < num_steps; ++i) {
    const double rise = std::clamp(((i + 0.5) * step - arrival) / ramp, 0.0, 1.0);
    const double traction = 2 * speed * rise * rise * (3 - 2 * rise);
    const double drive = std::exp(-law.delay_exponent * target_damage(law, traction));
    q -= q > drive ? -std::expm1(-law.delay_exponent * step) * (q - drive) : 0;
  }
  return -std::log(q) / law.delay_exponent;
}

SolvedRun pulled_bar(int dimension, int degree, double end) {
  testing::CaseText text = testing::unit_bar(dimension, degree, 0.25, end);
  const std::string pull = "normal_velocity = \"" + testing::digits(speed) + "\"\nramp = " + testing::digits(ramp);
  text.rest = testing::bar_sides(dimension, pull, pull) + testing::fracture_section({}) +
              testing::crack_across(dimension, 0.5 * testing::bar_length, 0);
  return testing::solve(text.text());
}

void expect_balance(const RunSummary::Energy& energy) {
  EXPECT_LE(std::fabs(energy.balance_error()), 1e-9 * (energy.initial + energy.external_work));
  EXPECT_GE(energy.numerical, 0);
  EXPECT_LE(energy.largest_patch_imbalance, 1e-9);
}

struct Variant {
  int dimension, degree;
  double bound;
};

class PreparedLine : public ::testing::TestWithParam<Variant> {};

TEST_P(PreparedLine, IsDamagedAsTheLawSaysUnderTheIncomingWaves) {
  const auto [dimension, degree, bound] = GetParam();
  double worst = 0;
  for (const double end : {3.3, 3.5, 3.7, 3.9}) {
    const SolvedRun run = pulled_bar(dimension, degree, end);
    const double exact = damage_of_the_law(end);
    for (const double found : {run.summary.fracture.damage_mean, run.summary.fracture.damage_max})
      worst = std::max(worst, std::fabs(found - exact));
    expect_balance(run.summary.energy);
    EXPECT_EQ(run.summary.energy.fracture > 0, exact > 0);
    EXPECT_EQ(run.summary.energy.friction, 0);
  }
  std::printf("  D = %d, k = %d: largest deviation of damage %.1e\n", dimension, degree, worst);
  EXPECT_GT(damage_of_the_law(3.9), 0.3);
  EXPECT_LE(worst, bound);
}

INSTANTIATE_TEST_SUITE_P(, PreparedLine,
                         ::testing::Values(Variant{1, 2, 1e-2}, Variant{1, 3, 4e-3}, Variant{2, 2, 1e-2},
                                           Variant{2, 3, 4e-3}),
                         [](const auto& variant) {
                           return "D" + std::to_string(variant.param.dimension) + "k" +
                                  std::to_string(variant.param.degree);
                         });

/// A bar strained by 0.9 and held at its ends: until waves from the surface return, those that come in are constant.
/// The smeared heads of these first-order waves are back some time before the exact 4.
TEST(PreparedPoint, FollowsTheClosedFormUnderConstantWaves) {
  constexpr double strain = 0.9;
  for (const double end : {0.4, 1.0, 1.4}) {
    testing::CaseText text = testing::unit_bar(1, 1, 0.25, end);
    text.rest = testing::bar_sides(1, "normal_velocity = \"0\"", "normal_velocity = \"0\"") +
                "[initial]\ndisplacement = [\"0.9*x\"]\n" + testing::fracture_section({}) +
                testing::crack_across(1, 0.5 * testing::bar_length, 0);
    const SolvedRun run = testing::solve(text.text());
    const double exact = relaxed_damage(law, target_damage(law, strain), 0, end);
    const double deviation = std::fabs(run.summary.fracture.damage_mean - exact);
    std::printf("  t = %.1f: damage %.6f, deviation %.1e\n", end, exact, deviation);
    EXPECT_GT(exact, 0.1);
    EXPECT_LE(deviation, 1e-12);
    expect_balance(run.summary.energy);
  }
}

}  // namespace
}  // namespace tentpole
