#include <algorithm>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>

#include "tests/host/run/polynomial_field.hpp"
#include "tests/host/run/solved_run.hpp"

// The patch test through every operation of an adaptive front. A polynomial has no dissipation but rounding noise, so a
// tolerance amid the noise refines and coarsens at random; smoothing adds flips and inclined tents on a bad mesh.
namespace tentpole {
namespace {

using testing::CaseText;
using testing::Polynomial;
using testing::SideKind;
using testing::Solid;

const Solid solid{1.3, 0.9, 0.8};

Simulation noisy_simulation(int dimension, int degree, double tolerance) {
  CaseText text;
  text.dimension = dimension;
  text.degree = degree;
  text.cells.assign(3, dimension == 1 ? 8 : 4);
  text.end = dimension == 1 ? 1.5 : 0.25;
  text.solid = solid;
  std::mt19937 engine(7 * dimension + degree);
  std::vector<int> variables{3};
  for (int axis = 0; axis < dimension; ++axis) variables.push_back(axis);
  std::vector<Polynomial> displacement;
  for (int i = 0; i < dimension; ++i) displacement.push_back(Polynomial::random(variables, degree, engine));
  text.rest = field_sections(polynomial_field(displacement, solid),
                             {SideKind::velocity, SideKind::traction, SideKind::roller, SideKind::slider});
  Simulation simulation = testing::simulation_of(text.text());
  simulation.settings.front.smoothing = true;
  AdaptivitySettings& adaptivity = simulation.settings.adaptivity;
  adaptivity.enabled = true;
  adaptivity.error_tolerance = tolerance;
  adaptivity.reference_energy = 1;
  adaptivity.coarsening = 0.9;
  adaptivity.min_size = 0.12;
  adaptivity.max_size = 0.5;
  return simulation;
}

/// Adds the operations of the run on the last device to `total`.
void expect_reproduced(int dimension, int degree, double tolerance, RunSummary::Counts& total) {
  const Simulation simulation = noisy_simulation(dimension, degree, tolerance);
  RunSummary summary;
  for (const Device& device : testing::test_devices()) {
    summary = testing::solve(simulation, device).summary;
    EXPECT_LE(summary.errors.value().displacement_l2_relative, 1e-11);
  }
  const RunSummary::Counts& counts = summary.counts;
  std::printf("  D = %d, k = %d: error %.1e, %ld patches, %ld splits, %ld deletions, %ld flips, %ld inclined\n",
              dimension, degree, summary.errors.value().displacement_l2_relative, long(counts.patches),
              long(counts.splits), long(counts.deletions), long(counts.flips), long(counts.inclined));
  total.splits += counts.splits;
  total.deletions += counts.deletions;
  total.flips += counts.flips;
  total.inclined += counts.inclined;
}

TEST(OperationsPatchTest, KeepsPolynomialsInOneDimension) {
  RunSummary::Counts total;
  expect_reproduced(1, 1, 1e-30, total);
  expect_reproduced(1, 2, 1e-29, total);
  expect_reproduced(1, 3, 3e-29, total);
  expect_reproduced(1, 4, 3e-29, total);
  EXPECT_GT(total.splits, 20);
  EXPECT_GT(total.deletions, 10);
}

TEST(OperationsPatchTest, KeepsPolynomialsInTwoDimensions) {
  RunSummary::Counts total;
  expect_reproduced(2, 1, 1e-31, total);
  expect_reproduced(2, 2, 2e-30, total);
  expect_reproduced(2, 3, 1e-29, total);
  EXPECT_GT(total.splits, 200);
  EXPECT_GT(total.deletions, 20);
  EXPECT_GT(total.flips, 2);
  EXPECT_GT(total.inclined, 20);
}

}  // namespace
}  // namespace tentpole
