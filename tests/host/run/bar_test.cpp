#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include <gtest/gtest.h>

#include "tests/host/run/case_text.hpp"
#include "tests/host/run/solved_run.hpp"

// Plane waves that jump or rise, against d'Alembert's solution.
namespace tentpole {
namespace {

using testing::CaseText;
using testing::Solid;

constexpr double tolerance = 1e-3;  // of smooth plane waves, relative to the incident amplitude

std::string probe(const char* name, const std::vector<double>& point, double interval) {
  return std::string("[[output.probe]]\nname = \"") + name + "\"\npoint = " + testing::number_list(point) +
         "\ninterval = " + testing::digits(interval) + "\n";
}

/// First time at which `values` passes `level`, by linear interpolation; NaN if it never does.
double crossing_time(const std::vector<double>& times, const std::vector<double>& values, double level) {
  for (std::size_t i = 1; i < times.size(); ++i)
    if (values[i - 1] < level && values[i] >= level)
      return times[i - 1] + (times[i] - times[i - 1]) * (level - values[i - 1]) / (values[i] - values[i - 1]);
  return NAN;
}

/// Largest |value - expected| for times in [first, last].
double largest_deviation(const std::vector<double>& times, const std::vector<double>& values, double expected,
                         double first, double last) {
  double deviation = 0;
  int samples = 0;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (times[i] >= first && times[i] <= last) {
      deviation = std::max(deviation, std::fabs(values[i] - expected));
      ++samples;
    }
  EXPECT_GT(samples, 5) << "no samples between " << first << " and " << last;
  return deviation;
}

std::map<std::string, testing::Table> probes_of(const testing::SolvedRun& run) {
  std::map<std::string, testing::Table> probes;
  for (const auto& [name, text] : run.files)
    if (name.starts_with("probe_")) probes[name.substr(6, name.size() - 10)] = testing::read_table(text);
  return probes;
}

/// The elastic bar of thesis 2.4.1: both ends of a bar of 1 mm are pulled with V = 6.1 m/s from t = 0 on, the long
/// sides slide without friction. Plane waves of stress rho c V = 200.5 MPa start from both ends and meet in the middle
/// after 56.1 ns.
class ElasticBar : public ::testing::Test {
 protected:
  static constexpr double density = 3690, youngs_modulus = 260e9, poisson_ratio = 0.21;
  static constexpr double pull = 6.1, length = 1e-3, end = 100e-9;
  static constexpr double front_width = 6e-9;  // [s] on both sides of an arrival, where the step is smeared

  Solid solid{density, youngs_modulus* poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio)),
              youngs_modulus / (2 * (1 + poisson_ratio))};
  double stress = density * solid.dilatational_speed() * pull;

  /// sxx over time at the points named "quarter" and "middle".
  std::map<std::string, testing::Table> solve() {
    CaseText text;
    text.dimension = 2;
    text.degree = 3;
    text.cells = {80, 4};
    text.max = {length, 0.2e-3};
    text.end = end;
    text.solid = solid;
    text.batch_size = 256;
    const std::string end_side = "normal_velocity = \"" + testing::digits(pull) + "\"\ntangential_velocity = \"0\"\n";
    const std::string long_side = "normal_velocity = \"0\"\ntangential_traction = \"0\"\n";
    text.rest = probe("quarter", {0.25 * length, 0.1e-3}, 0.1e-9) + probe("middle", {0.5 * length, 0.1e-3}, 0.1e-9) +
                "[boundary.left]\n" + end_side + "[boundary.right]\n" + end_side + "[boundary.bottom]\n" + long_side +
                "[boundary.top]\n" + long_side;
    return probes_of(testing::solve(text.text()));
  }

  void expect_arrival(const testing::Table& table, double stress_before, double stress_after, double exact) {
    const double found = crossing_time(table.at("time"), table.at("sxx"), 0.5 * (stress_before + stress_after));
    std::printf("  arrival at %.3f ns, exact %.3f ns\n", found * 1e9, exact * 1e9);
    EXPECT_NEAR(found, exact, 0.5e-9);
  }

  /// Within 1 % of the bar's stress away from the fronts.
  void expect_stress(const testing::Table& table, double expected, double after_front, double before_front) {
    const double deviation = largest_deviation(table.at("time"), table.at("sxx"), expected, after_front + front_width,
                                               before_front - front_width);
    std::printf("  %.1f MPa: deviation %.2f MPa\n", expected * 1e-6, deviation * 1e-6);
    EXPECT_LE(deviation, 0.01 * std::max(expected, stress));
  }
};

TEST_F(ElasticBar, StressOfThePlaneWavesIsTheThesisValue) {
  EXPECT_NEAR(stress, 200.5e6, 0.05e6);
}

TEST_F(ElasticBar, WavesOfTheThesisStressArriveInTimeAndAddUpWhereTheyMeet) {
  const std::map<std::string, testing::Table> probes = solve();
  const double crossing = length / solid.dilatational_speed();
  const testing::Table& quarter = probes.at("quarter");
  expect_arrival(quarter, 0, stress, 0.25 * crossing);
  expect_arrival(quarter, stress, 2 * stress, 0.75 * crossing);
  expect_stress(quarter, 0, -end, 0.25 * crossing);
  expect_stress(quarter, stress, 0.25 * crossing, 0.75 * crossing);
  expect_stress(quarter, 2 * stress, 0.75 * crossing, 2 * end);
  const testing::Table& middle = probes.at("middle");
  expect_arrival(middle, 0, 2 * stress, 0.5 * crossing);
  expect_stress(middle, 0, -end, 0.5 * crossing);
  expect_stress(middle, 2 * stress, 0.5 * crossing, 2 * end);
}

/// Speed 1 and impedance 1 for x < 1, speed 1/2 and the impedance given beyond. A stress of 1 rises at x = 0 and meets
/// the interface at t = 1.
void expect_reflection(double impedance) {
  const double density = 2 * impedance, modulus = impedance / 2, rise = 0.2;
  CaseText text;
  text.degree = 3;
  text.cells = {60};
  text.max = {2};
  text.structured = true;  // the interface is a vertex
  text.end = 1.95;
  text.solid = {1, 0, 0.5};
  text.rest = probe("before", {0.5}, 0.01) + probe("beyond", {1.2}, 0.01) +
              "[boundary.left]\ntraction = [\"-1\"]\nramp = 0.2\nramp_order = \"quintic\"\n[boundary.right]\nabsorbing "
              "= true\n";
  Simulation simulation = testing::simulation_of(text.text());
  testing::give_second_material(simulation, 1, {density, 0, modulus / 2});
  const std::map<std::string, testing::Table> probes = probes_of(testing::solve(simulation));
  const testing::Table &before = probes.at("before"), &beyond = probes.at("beyond");
  const double reflected = (impedance - 1) / (impedance + 1), transmitted = 2 * impedance / (1 + impedance);
  const double incident = largest_deviation(before.at("time"), before.at("sxx"), 1, 0.5 + rise + 0.05, 1.5 - 0.05);
  const double sum = largest_deviation(before.at("time"), before.at("sxx"), 1 + reflected, 1.5 + rise + 0.05, 2);
  const double through = largest_deviation(beyond.at("time"), beyond.at("sxx"), transmitted, 1.4 + rise + 0.05, 2);
  const double velocity =
      largest_deviation(beyond.at("time"), beyond.at("vx"), -transmitted / impedance, 1.4 + rise + 0.05, 2);
  std::printf(
      "  Z2 / Z1 = %.2f: reflected %.2f, transmitted %.2f; deviations of the incident wave %.1e, reflected %.1e, "
      "transmitted %.1e, its velocity %.1e\n",
      impedance, reflected, transmitted, incident, sum, through, velocity);
  EXPECT_LE(std::max({incident, sum, through, velocity}), tolerance);
}

TEST(TwoMaterialBar, ReflectsAndTransmitsByImpedance) {
  for (const double impedance : {4.0, 0.25, 1.0}) expect_reflection(impedance);
}

}  // namespace
}  // namespace tentpole
