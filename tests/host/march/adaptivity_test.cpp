#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/host/march/tables.hpp"
#include "tests/host/run/case_text.hpp"
#include "tests/host/run/solved_run.hpp"

// A plane Gaussian pulse that runs through a long bar: cells follow it.
namespace tentpole {
namespace {

using testing::SolvedRun;

struct Adaptivity {
  double tolerance = 1e-5;
  double min_size = 1e-3;
};

class GaussianPulse : public ::testing::TestWithParam<int> {
 protected:
  static constexpr int degree = 3;
  int dimension() const { return GetParam(); }

  testing::CaseText pulse(int cells, double end) const {
    testing::CaseText text;
    text.dimension = dimension();
    text.degree = degree;
    text.cells = {cells, cells / 16};
    text.max = {4, 0.25};
    text.structured = dimension() == 1;
    text.end = end;
    text.solid = {1, 0, 0.5};
    const auto vector = [&](const std::string& first) {
      return "[\"" + first + (dimension() == 2 ? "\", \"0\"]\n" : "\"]\n");
    };
    text.rest = "[boundary.left]\nabsorbing = true\n[boundary.right]\nabsorbing = true\n[initial]\ndisplacement = " +
                vector("0.01*exp(-((x-0.5)/0.12)^2)") +
                "velocity = " + vector("0.02*(x-0.5)/0.0144*exp(-((x-0.5)/0.12)^2)") +
                "[exact]\ndisplacement = " + vector("0.01*exp(-((x-t-0.5)/0.12)^2)");
    if (dimension() == 2)
      for (const char* side : {"bottom", "top"})
        text.rest += std::string("[boundary.") + side + "]\nnormal_velocity = \"0\"\ntangential_traction = \"0\"\n";
    return text;
  }

  SolvedRun uniform_run(int cells) const { return testing::solve(pulse(cells, 1).text()); }

  SolvedRun adaptive_run(const Adaptivity& adaptivity, double end = 1) const {
    testing::CaseText text = pulse(16, end);
    text.rest +=
        "[adaptivity]\nenabled = true\nmax_size = 0.3\nerror_tolerance = " + testing::digits(adaptivity.tolerance) +
        "\nmin_size = " + testing::digits(adaptivity.min_size) + "\n";
    return testing::solve(text.text());
  }
};

double energy_error(const SolvedRun& run) {
  return run.summary.errors.value().energy_norm;
}

TEST_P(GaussianPulse, NeedsFewerElementsForTheSameError) {
  const SolvedRun adaptive = adaptive_run({}), uniform = uniform_run(dimension() == 1 ? 120 : 64);
  const RunSummary::Counts& counts = adaptive.summary.counts;
  const double gain = double(uniform.summary.counts.elements) / counts.elements,
               rejected = double(counts.rejected) / (counts.rejected + counts.patches);
  std::printf(
      "  D = %d: uniform %.2e with %lld elements, adaptive %.2e with %lld: %.1f times fewer, %.0f %% rejected\n",
      dimension(), energy_error(uniform), static_cast<long long>(uniform.summary.counts.elements),
      energy_error(adaptive), static_cast<long long>(counts.elements), gain, 100 * rejected);
  EXPECT_LE(energy_error(adaptive), energy_error(uniform));
  EXPECT_GE(gain, 3.3);
  EXPECT_LE(rejected, 0.25);
  EXPECT_GT(counts.rejected, 0);
  EXPECT_EQ(counts.min_size_hits, 0);
  EXPECT_TRUE(adaptive.summary.warnings.empty()) << adaptive.summary.warnings.front();
  const RunSummary::Energy& energy = adaptive.summary.energy;
  EXPECT_LE(std::fabs(energy.balance_error()), 1e-9 * energy.initial);
  EXPECT_LE(energy.largest_patch_imbalance, 1e-9);
}

TEST_P(GaussianPulse, IsMoreAccurateWithHalfOfTheTolerance) {
  double error = INFINITY, dissipation = INFINITY;
  for (const double tolerance : {8e-5, 4e-5, 2e-5}) {
    const SolvedRun run = adaptive_run({.tolerance = tolerance});
    EXPECT_LT(energy_error(run), error) << tolerance;
    EXPECT_LT(run.summary.energy.numerical, dissipation) << tolerance;
    error = energy_error(run);
    dissipation = run.summary.energy.numerical;
  }
}

TEST_P(GaussianPulse, LeavesACoarseMeshBehind) {
  const SolvedRun run = adaptive_run({.tolerance = 1e-4}, 4.4);
  const RunSummary::Counts& counts = run.summary.counts;
  const std::vector<double> cells = testing::table_of(run, "history.csv").at("cells");
  std::printf("  D = %d: from %.0f cells up to %lld and down to %.0f, %lld splits, %lld deletions\n", dimension(),
              cells.front(), static_cast<long long>(counts.cells_max), cells.back(),
              static_cast<long long>(counts.splits), static_cast<long long>(counts.deletions));
  EXPECT_GT(counts.deletions, 0);
  EXPECT_GE(counts.cells_max, 1.5 * cells.back());
}

TEST_P(GaussianPulse, CountsWhereTheLeastSizeForbidsRefinement) {
  const double min_size = dimension() == 1 ? 0.1 : 0.15;
  const SolvedRun run = adaptive_run({.tolerance = 1e-6, .min_size = min_size});
  const RunSummary& summary = run.summary;
  EXPECT_GT(summary.counts.min_size_hits, 0);
  EXPECT_TRUE(std::ranges::any_of(summary.warnings, [&](const std::string& warning) {
    return warning.find(std::to_string(summary.counts.min_size_hits) + " elements") != std::string::npos &&
           warning.find("adaptivity.min_size") != std::string::npos;
  }));
  // A cell above the least size is bisected at its longest edge.
  EXPECT_GE(summary.counts.smallest_cell, 0.25 * min_size);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, GaussianPulse, ::testing::Values(1, 2));

}  // namespace
}  // namespace tentpole
