#include "kernels/fracture/damage_law.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "kernels/element/quadrature.hpp"

namespace tentpole {
namespace {

constexpr FractureLaw law{300, 400, 2, 10, 0.5, 0.3};

/// D at the ends of panels of one length, f given at any time.
template <class Target>
std::vector<double> damage_history(double duration, int num_panels, int num_points, double start, const Target& f) {
  const Quadrature rule = gauss_jacobi(num_points, 0);
  std::vector<double> history{start}, target(num_points), damage(num_points);
  double q = std::exp(-law.delay_exponent * start);
  for (int panel = 0; panel < num_panels; ++panel) {
    for (int p = 0; p < num_points; ++p) target[p] = f((panel + rule.points[p]) * duration);
    q = integrate_damage_panel(law, duration, {num_points, rule.points.data(), rule.weights.data()}, target.data(), q,
                               damage.data());
    history.push_back(-std::log(q) / law.delay_exponent);
  }
  return history;
}

TEST(DamageLaw, EffectiveTractionTakesTensionAndWeightedShear) {
  EXPECT_DOUBLE_EQ(effective_traction(law, 3, 8), 5);
  EXPECT_DOUBLE_EQ(effective_traction(law, -3, 8), 4);
}

TEST(DamageLaw, TargetIsTheSmoothStepBetweenThresholdAndStrength) {
  EXPECT_EQ(target_damage(law, 299), 0);
  EXPECT_DOUBLE_EQ(target_damage(law, 325), 3.0 / 16 - 2.0 / 64);
  EXPECT_DOUBLE_EQ(target_damage(law, 350), 0.5);
  EXPECT_EQ(target_damage(law, 401), 1);
}

TEST(DamageLaw, ConstantTargetFollowsTheClosedFormForPanelsOfAnyLength) {
  for (const double duration : {0.01, 0.2, 3.0, 50.0})
    for (const double target : {0.05, 0.4, 1.0})
      for (const int num_points : {1, 3, 7}) {
        const std::vector<double> damage =
            damage_history(duration, 5, num_points, 0.03, [&](double) { return target; });
        for (int panel = 0; panel <= 5; ++panel)
          EXPECT_NEAR(damage[panel], relaxed_damage(law, target, 0.03, panel * duration), 1e-15);
      }
}

TEST(DamageLaw, ClosedFormSolvesTheDifferentialEquation) {
  const double step = 1e-6;
  for (const double time : {0.1, 1.0, 3.0}) {
    const double damage = relaxed_damage(law, 0.8, 0.1, time);
    const double rate =
        (relaxed_damage(law, 0.8, 0.1, time + step) - relaxed_damage(law, 0.8, 0.1, time - step)) / (2 * step);
    EXPECT_NEAR(rate, (1 - std::exp(-law.delay_exponent * (0.8 - damage))) / law.relaxation_time, 1e-8);
  }
}

TEST(DamageLaw, NeverShrinksAndNeverPassesTheLargestTarget) {
  const auto target = [](double time) { return 0.45 + 0.45 * std::sin(3 * time + 0.4 * std::sin(7 * time)); };
  for (const double duration : {0.05, 0.5, 4.0}) {
    const std::vector<double> damage = damage_history(duration, 40, 3, 0, target);
    for (std::size_t i = 1; i < damage.size(); ++i) EXPECT_GE(damage[i], damage[i - 1]);
    EXPECT_LE(damage.back(), 0.9 + 1e-14);
    EXPECT_GT(damage.back(), 0.3);
  }
}

TEST(DamageLaw, PanelsFarShorterThanTheRelaxationTimeLoseNoDigits) {
  FractureLaw slow = law;
  slow.relaxation_time = 1e12;
  const double abscissa[] = {0.1, 0.5, 0.9}, weight[] = {0.3, 0.4, 0.3}, target[] = {0.2, 0.5, 0.9};
  double damage[3];
  const double q = integrate_damage_panel(slow, 1, {3, abscissa, weight}, target, std::exp(-1.0), damage);
  EXPECT_NEAR(q, std::exp(-1.0), 1e-11);
  for (const double value : damage) EXPECT_NEAR(value, 0.1, 1e-11);
}

TEST(DamageLaw, ARampConvergesToAFineIntegrationWithOrderTwoAtLeast) {
  const auto target = [](double time) { return std::min(1.0, time / 3) * std::min(1.0, time / 3); };
  const double fine = damage_history(4.0 / 16384, 16384, 3, 0, target).back();
  const double coarse = std::abs(damage_history(0.2, 20, 3, 0, target).back() - fine);
  const double finer = std::abs(damage_history(0.1, 40, 3, 0, target).back() - fine);
  EXPECT_LT(coarse, 2e-4);
  EXPECT_LT(finer, coarse / 3.5);
}

}  // namespace
}  // namespace tentpole
