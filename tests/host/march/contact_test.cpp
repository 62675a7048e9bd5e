#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/host/march/tables.hpp"
#include "tests/host/march/unit_bar.hpp"

// A failed surface at mid-span of a bar opens, closes and opens again under a wave of tension, pressure and tension,
// against the solution by characteristics. When it closes a jump of stress starts: errors are of first order.
namespace tentpole {
namespace {

using testing::Table;

constexpr double start = 0.1, half_period = 0.6, crack = 0.5 * testing::bar_length;
constexpr double amplitude[3] = {0.5, 1, 0.5};  // of the three half waves

/// Stress of the incident wave at the surface at a time: half waves amplitude sin^3, negative in the second.
double incident(double time) {
  const double phase = (time - start) / half_period;
  if (phase <= 0 || phase >= 3) return 0;
  return amplitude[static_cast<int>(phase)] * std::pow(std::sin(M_PI * phase), 3);
}

/// Half periods at x since the wave began there, as an expression.
std::string phase() {
  return "((2-x-" + testing::digits(start) + ")/" + testing::digits(half_period) + ")";
}

/// The displacement u(x, 0) with du/dx = incident(2 - x), as an expression: with the antiderivative F = -cos + cos^3 /
/// 3 of sin^3, u = -(half_period / pi) (amplitude (F - F at the start of the half wave) + those of the half waves
/// before).
std::string displacement() {
  const std::string cosine = "cos(pi*" + phase() + ")", antiderivative = "(-" + cosine + "+" + cosine + "^3/3)";
  constexpr double integral[3] = {amplitude[0] * 4 / 3, -amplitude[1] * 4 / 3, amplitude[2] * 4 / 3};
  double before = integral[0] + integral[1] + integral[2];
  std::string text = testing::digits(before);
  for (int half = 2; half >= 0; --half) {
    const double antiderivative_at_start = half == 1 ? 2.0 / 3 : -2.0 / 3;
    before -= integral[half];
    text = phase() + "<" + std::to_string(half + 1) + " ? " + testing::digits(amplitude[half]) + "*(" + antiderivative +
           "-(" + testing::digits(antiderivative_at_start) + "))+(" + testing::digits(before) + ") : (" + text + ")";
  }
  return "-" + testing::digits(half_period / M_PI) + "*(" + phase() + "<0 ? 0 : (" + text + "))";
}

/// v(x, 0) = -incident(2 - x): the wave runs to the right.
std::string velocity() {
  const std::string factor =
      phase() + ">1 && " + phase() + "<2 ? -" + testing::digits(amplitude[1]) + " : -" + testing::digits(amplitude[0]);
  return phase() + "<0 || " + phase() + ">3 ? 0 : (" + factor + ")*sin(pi*" + phase() + ")^3";
}

/// What the surface does over time, by the midpoint rule.
class Characteristics {
 public:
  Characteristics(double end, int num_steps) : step_(end / num_steps), passed_{0}, impulse_{0} {
    double gap = 0;
    for (int i = 0; i < num_steps; ++i) {
      const double stress = incident((i + 0.5) * step_);
      // Open: no traction, and the left face alone moves, by twice the incident wave. Closed: the wave passes.
      const bool is_open = gap > 0 || stress > 0;
      if (is_open) gap = std::max(0.0, gap + 2 * stress * step_);
      num_changes_ += is_open != was_open_;
      was_open_ = is_open;
      largest_gap_ = std::max(largest_gap_, gap);
      const double traction = is_open ? 0 : stress;
      passed_.push_back(traction);
      impulse_.push_back(impulse_.back() + traction * step_);
    }
  }
  double traction(double time) const { return at(passed_, time); }
  /// int traction dt
  double impulse(double time) const { return at(impulse_, time); }
  double largest_gap() const { return largest_gap_; }
  int num_changes() const { return num_changes_; }

 private:
  double at(const std::vector<double>& values, double time) const {
    if (time <= 0) return 0;
    return values[std::min(values.size() - 1, static_cast<std::size_t>(std::lround(time / step_)))];
  }

  double step_, largest_gap_ = 0;
  std::vector<double> passed_, impulse_;
  bool was_open_ = false;
  int num_changes_ = 0;
};

class Contact : public ::testing::TestWithParam<int> {};

TEST_P(Contact, OpensClosesAndOpensAgain) {
  constexpr double end = 2.75;
  const int degree = GetParam();
  testing::CaseText text = testing::unit_bar(1, degree, 0.025, end);
  text.rest = "[boundary.left]\nabsorbing = true\n[boundary.right]\nabsorbing = true\n[initial]\ndisplacement = [\"" +
              displacement() + "\"]\nvelocity = [\"" + velocity() + "\"]\n" +
              testing::bar_probe(1, "before", 1.52, 0.01) + testing::bar_probe(1, "behind", 2.48, 0.01) +
              testing::fracture_section({.threshold = 1e3, .strength = 2e3, .relaxation_time = 100}) +
              testing::crack_across(1, crack, 1);
  const testing::SolvedRun run = testing::solve(text.text());
  const Characteristics exact(end, 20000);
  EXPECT_EQ(exact.num_changes(), 3) << "open, closed, open";
  const Table behind = testing::table_of(run, "probe_behind.csv"), before = testing::table_of(run, "probe_before.csv");
  const std::size_t num_rows = behind.at("time").size();
  double displacement_error = 0, stress_error = 0, reflection_error = 0;
  for (std::size_t row = 0; row < num_rows; ++row) {
    const double time = behind.at("time")[row], delayed = time - 0.48;
    // Behind: s = -v is the traction of the surface. Before: the incident wave and the reflected rest.
    displacement_error = std::max(displacement_error, std::fabs(behind.at("ux")[row] + exact.impulse(delayed)));
    stress_error += std::fabs(behind.at("sxx")[row] - exact.traction(delayed)) / num_rows;
    const double reflected = delayed > 0 ? exact.traction(delayed) - incident(delayed) : 0;
    reflection_error += std::fabs(before.at("sxx")[row] - incident(time + 0.48) - reflected) / num_rows;
  }
  std::printf("  k = %d: displacement %.1e of the gap %.3f, mean of the stress %.1e and %.1e of 1\n", degree,
              displacement_error, exact.largest_gap(), stress_error, reflection_error);
  EXPECT_LE(displacement_error, 0.03 * exact.largest_gap());
  EXPECT_LE(stress_error, 0.012);
  EXPECT_LE(reflection_error, 0.012);
  const RunSummary::Energy& energy = run.summary.energy;
  EXPECT_LE(std::fabs(energy.balance_error()), 1e-9 * energy.initial);
  EXPECT_EQ(energy.friction, 0);
}

INSTANTIATE_TEST_SUITE_P(Degrees, Contact, ::testing::Values(2, 3));

}  // namespace
}  // namespace tentpole
