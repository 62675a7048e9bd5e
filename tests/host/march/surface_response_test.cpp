#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/host/march/tables.hpp"
#include "tests/host/march/unit_bar.hpp"

// What a fracture surface of constant damage does to waves: nothing while it is bonded or closed; open it is a free
// end; closed and sliding it passes what friction bears.
namespace tentpole {
namespace {

using testing::SolvedRun;
using testing::Table;

/// No damage grows: no traction reaches the threshold.
const testing::FractureText constant_damage{.threshold = 1e3, .strength = 2e3, .relaxation_time = 100, .friction = 0.3};

class SurfaceInBar : public ::testing::TestWithParam<int> {
 protected:
  int dimension() const { return GetParam(); }

  /// A bar with initial strain, a smooth load on the left end added to the stress of this strain, a free or loaded
  /// right end, probes on both sides of mid-span, sections on fracture, and what else is in [initial].
  SolvedRun loaded_bar(double strain, const std::string& load, double end, const std::string& fracture,
                       const std::string& initial = "") const {
    testing::CaseText text = testing::unit_bar(dimension(), 3, 0.25, end);
    text.history_rows = 20;
    const std::string stress = testing::digits(strain);  // lambda + 2 mu = 1
    text.rest = testing::bar_sides(dimension(), "normal_traction = \"" + stress + "+" + load + "\"",
                                   "normal_traction = \"" + stress + "\"") +
                "[initial]\ndisplacement = [\"" + stress + "*x\"" + (dimension() == 2 ? ", \"0\"]\n" : "]\n") +
                initial + testing::bar_probe(dimension(), "before", 1.45, 0.05) +
                testing::bar_probe(dimension(), "behind", 2.55, 0.05) + fracture;
    return testing::solve(text.text());
  }

  std::string surface(double damage) const {
    return testing::fracture_section(constant_damage) +
           testing::crack_across(dimension(), 0.5 * testing::bar_length, damage);
  }

  void expect_same_waves(const SolvedRun& expected, const SolvedRun& found) const {
    EXPECT_EQ(expected.summary.counts.patches, found.summary.counts.patches);
    for (const char* file : {"probe_before.csv", "probe_behind.csv"}) {
      Table first = testing::table_of(expected, file), second = testing::table_of(found, file);
      for (const char* zero : {"uy", "vy", "sxy"}) {
        first.erase(zero);
        second.erase(zero);
      }
      EXPECT_LE(testing::largest_difference(first, second), 1e-11) << file;
    }
    Table first = testing::table_of(expected, "history.csv"), second = testing::table_of(found, "history.csv");
    for (const char* other :
         {"crack_length", "damage_mean", "damage_max", "fragments", "numerical", "fracture", "friction"}) {
      first.erase(other);
      second.erase(other);
    }
    EXPECT_LE(testing::largest_difference(first, second), 1e-11);
    EXPECT_NEAR(expected.summary.energy.numerical, found.summary.energy.numerical,
                1e-11 * expected.summary.energy.external_work);
    EXPECT_NEAR(found.summary.energy.fracture, 0, 1e-11 * expected.summary.energy.external_work);
  }
};

const std::string tensile_rise = "0.5*min(1,t)^3*(10-15*min(1,t)+6*min(1,t)^2)";

TEST_P(SurfaceInBar, BondedIsAsIfItWereNotThere) {
  const SolvedRun whole = loaded_bar(0, tensile_rise, 5, testing::fracture_section(constant_damage));
  expect_same_waves(whole, loaded_bar(0, tensile_rise, 5, surface(0)));
}

TEST_P(SurfaceInBar, FailedButPressedTogetherIsAsIfItWereNotThere) {
  const std::string load = "(-1)*" + tensile_rise;
  const SolvedRun whole = loaded_bar(-0.1, load, 3.5, testing::fracture_section(constant_damage));
  expect_same_waves(whole, loaded_bar(-0.1, load, 3.5, surface(1)));
}

double rise(double time) {
  const double r = std::clamp(time, 0.0, 1.0);
  return 0.5 * r * r * r * (10 - 15 * r + 6 * r * r);
}

/// Largest deviation in front of mid-span from stress and velocity of the incident wave and its reflection at a free
/// end.
double deviation_from_free_end(const Table& before) {
  double deviation = 0;
  for (std::size_t row = 0; row < before.at("time").size(); ++row) {
    const double time = before.at("time")[row], incident = rise(time - 1.45), reflected = -rise(time - 2.55);
    deviation = std::max({deviation, std::fabs(before.at("sxx")[row] - (incident + reflected)),
                          std::fabs(before.at("vx")[row] - (reflected - incident))});
  }
  return deviation;
}

double largest_distance(const std::vector<double>& values, double expected) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::fabs(value - expected));
  return largest;
}

TEST_P(SurfaceInBar, OpenReflectsLikeAFreeEndAndPassesNothing) {
  const std::string parting = "velocity = [\"x < 2 ? 0 : 0.05\"" + std::string(dimension() == 2 ? ", \"0\"]\n" : "]\n");
  const SolvedRun run = loaded_bar(0, tensile_rise, 4, surface(1), parting);
  const Table before = testing::table_of(run, "probe_before.csv"), behind = testing::table_of(run, "probe_behind.csv");
  const double deviation = deviation_from_free_end(before);
  std::printf("  D = %d: deviation from the free end %.1e of 0.5\n", dimension(), deviation);
  EXPECT_LE(deviation, 1e-2);
  EXPECT_LE(largest_distance(behind.at("sxx"), 0), 1e-10);
  EXPECT_LE(largest_distance(behind.at("vx"), 0.05), 1e-10);
  EXPECT_EQ(run.summary.fracture.fragments.size(), 2u);
  EXPECT_NEAR(run.summary.energy.fracture, 0, 1e-12) << "no traction on an open surface";
}

/// The polynomials' oscillation ahead of the wave may press the surface together, and passes.
TEST_P(SurfaceInBar, FailedOpensUnderTension) {
  const SolvedRun run = loaded_bar(0, tensile_rise, 4, surface(1));
  const Table before = testing::table_of(run, "probe_before.csv"), behind = testing::table_of(run, "probe_behind.csv");
  const double deviation = deviation_from_free_end(before), passed = largest_distance(behind.at("sxx"), 0);
  std::printf("  D = %d: deviation from the free end %.1e, passed %.1e, of 0.5\n", dimension(), deviation, passed);
  EXPECT_LE(deviation, 1e-2);
  EXPECT_LE(passed, 5e-3);
}

TEST_P(SurfaceInBar, HalfDamagedPassesHalfOfTheTension) {
  const SolvedRun run = loaded_bar(0, tensile_rise, 4, surface(0.5));
  const Table behind = testing::table_of(run, "probe_behind.csv");
  double deviation = 0;
  for (std::size_t row = 0; row < behind.at("time").size(); ++row)
    deviation = std::max(deviation, std::fabs(behind.at("sxx")[row] - 0.5 * rise(behind.at("time")[row] - 2.55)));
  std::printf("  D = %d: deviation of the transmitted stress %.1e, of 0.25\n", dimension(), deviation);
  EXPECT_LE(deviation, 5e-3);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, SurfaceInBar, ::testing::Values(1, 2));

/// A shear wave meets a failed surface under pressure. The traction that friction bears passes; the work of friction is
/// that traction times the sliding.
TEST(SlidingSurface, PassesTheTractionOfFriction) {
  constexpr double pressure = 1, end = 3, place = 1;
  const double friction = constant_damage.friction;
  testing::CaseText text = testing::unit_bar(2, 3, 0.25, end);
  const double speed = text.solid.shear_speed(), impedance = speed, strain = -pressure;
  const std::string long_sides =
      "normal_traction = \"" + testing::digits(text.solid.lambda * strain) + "\"\ntangential_velocity = \"0\"\n";
  // The tangent of the left side is -y: the traction on it in -y is sigma_xy.
  text.rest = "[boundary.left]\nnormal_traction = \"-1\"\ntangential_traction = \"" + tensile_rise +
              "\"\n[boundary.right]\nnormal_traction = \"-1\"\ntangential_traction = \"0\"\n[boundary.bottom]\n" +
              long_sides + "[boundary.top]\n" + long_sides + "[initial]\ndisplacement = [\"-x\", \"0\"]\n" +
              testing::bar_probe(2, "behind", 1.3, 0.02) + testing::fracture_section(constant_damage) +
              testing::crack_across(2, place, 1);
  const SolvedRun run = testing::solve(text.text());
  const Table behind = testing::table_of(run, "probe_behind.csv");
  const std::size_t num_rows = behind.at("time").size();
  double deviation = 0;  // the mean: where sliding begins the wave has a kink
  for (std::size_t row = 0; row < num_rows; ++row) {
    const double incident = rise(behind.at("time")[row] - 1.3 / speed);
    deviation += std::fabs(behind.at("sxy")[row] - std::min(incident, friction * pressure)) / num_rows;
  }
  double work = 0;
  constexpr int num_steps = 10000;
  for (int step = 0; step < num_steps; ++step) {
    const double incident = rise((step + 0.5) * end / num_steps - place / speed);
    const double passed = std::min(incident, friction * pressure);
    work += passed * 2 * (incident - passed) / impedance * end / num_steps * testing::bar_width;
  }
  const RunSummary::Energy& energy = run.summary.energy;
  std::printf("  mean deviation of the stress %.1e of %.1f, friction %.5f, exact %.5f\n", deviation,
              friction * pressure, energy.friction, work);
  EXPECT_LE(deviation, 0.02 * friction * pressure);
  EXPECT_NEAR(energy.friction, work, 0.01 * work);
  EXPECT_NEAR(energy.fracture, 0, 1e-3 * work);
  EXPECT_LE(std::fabs(energy.balance_error()), 1e-9 * (energy.initial + energy.external_work));
}

}  // namespace
}  // namespace tentpole
