#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "kernels/patch_solver.hpp"
#include "kernels/solve_patch.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

/// Solves the batch in host memory by a team of `lanes` threads, as a GPU does with teams of its own: the path that a
/// CPU device never takes, with as many lanes as we like, and open to the thread sanitizer.
template <int D>
TentBatch solved_together(TentBatch batch, int lanes) {
  const ReferenceTables tables(batch.dimension, batch.degree);
  std::vector<double> scratch(patch_scratch_size(tables.view(), batch.patches, lanes));
  const PatchBatch view = batch.view();
#pragma omp parallel num_threads(lanes)
  {
    const TeamLanes team{omp_get_thread_num(), omp_get_num_threads()};
    StageCycles cycles;
    for (int patch = 0; patch < view.num_patches; ++patch) {
      solve_patch<D>(view, tables.view(), patch, scratch.data(), cycles, team);
      team.synchronize();
    }
  }
  return batch;
}

template <int D>
void expect_serial_solution(int highest_degree) {
  for (int degree = 1; degree <= highest_degree; ++degree) {
    TentOptions options;
    options.num_patches = 1;
    options.num_materials = 2;
    const TentBatch batch = random_tents(D, degree, options, 90 + degree), expected = solved(batch);
    double scale = 0, energy = 0;
    for (const double coefficient : expected.coefficients) scale = std::max(scale, std::abs(coefficient));
    for (const ElementRecord& record : expected.records) energy = std::max(energy, record.inflow_energy);
    for (const int lanes : {2, 3}) {
      const TentBatch found = solved_together<D>(batch, lanes);
      for (std::size_t i = 0; i < found.coefficients.size(); ++i)
        ASSERT_NEAR(found.coefficients[i], expected.coefficients[i], 1e-12 * scale)
            << "lanes " << lanes << " degree " << degree;
      for (std::size_t e = 0; e < found.records.size(); ++e) {
        ASSERT_EQ(found.records[e].status, int(Status::ok)) << "lanes " << lanes << " degree " << degree;
        ASSERT_NEAR(found.records[e].outflow_energy, expected.records[e].outflow_energy, 1e-12 * energy);
        ASSERT_NEAR(found.records[e].dissipation, expected.records[e].dissipation, 1e-12 * energy);
        ASSERT_NEAR(found.records[e].external_work, expected.records[e].external_work, 1e-12 * energy);
      }
    }
  }
}

TEST(CooperativePatch, EqualsTheSerialSolutionInOneDimension) {
  expect_serial_solution<1>(3);
}
TEST(CooperativePatch, EqualsTheSerialSolutionInTwoDimensions) {
  expect_serial_solution<2>(2);
}
TEST(CooperativePatch, EqualsTheSerialSolutionInThreeDimensions) {
  expect_serial_solution<3>(1);
}

}  // namespace
}  // namespace tentpole
