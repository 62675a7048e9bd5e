#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "tests/kernels/device_tents.hpp"
#include "tests/kernels/general_patches.hpp"
#include "tests/kernels/solved_together.hpp"

namespace tentpole {
namespace {

/// Numbers of lanes: alone, fewer than a warp and no power of two, a warp, and more than any patch here has rows.
constexpr int lane_counts[] = {1, 2, 7, 32, 128};

/// Solution and records of teams of lanes against those of one thread.
void expect_serial_solution(const TentBatch& batch, const std::string& what) {
  const TentBatch expected = solved(batch);
  double scale = 0, energy = 0;
  for (const double coefficient : expected.coefficients)
    if (!std::isnan(coefficient)) scale = std::max(scale, std::abs(coefficient));
  for (const ElementRecord& record : expected.records) energy = std::max(energy, record.inflow_energy);
  for (const int lanes : lane_counts) {
    const TentBatch found = solved_together(batch, lanes);
    const std::string where = what + ", " + std::to_string(lanes) + " lanes";
    for (std::size_t i = 0; i < found.coefficients.size(); ++i) {
      if (std::isnan(expected.coefficients[i])) continue;
      ASSERT_NEAR(found.coefficients[i], expected.coefficients[i], 1e-12 * scale) << where;
    }
    for (std::size_t e = 0; e < found.records.size(); ++e) {
      const ElementRecord &a = found.records[e], &b = expected.records[e];
      ASSERT_EQ(a.status, int(Status::ok)) << where;
      ASSERT_NEAR(a.inflow_energy, b.inflow_energy, 1e-12 * energy) << where;
      ASSERT_NEAR(a.initial_energy, b.initial_energy, 1e-12 * energy) << where;
      ASSERT_NEAR(a.outflow_energy, b.outflow_energy, 1e-12 * energy) << where;
      ASSERT_NEAR(a.dissipation, b.dissipation, 1e-12 * energy) << where;
      ASSERT_NEAR(a.external_work, b.external_work, 1e-12 * energy) << where;
      ASSERT_NEAR(a.max_principal_stress, b.max_principal_stress, 1e-11 * (1 + std::abs(b.max_principal_stress)))
          << where;
    }
  }
}

void expect_serial_solution_of_tents(int dimension, int highest_degree) {
  for (int degree = 1; degree <= highest_degree; ++degree) {
    TentOptions options;
    options.num_patches = 2;
    options.num_materials = 2;
    expect_serial_solution(random_tents(dimension, degree, options, 90 + degree), "degree " + std::to_string(degree));
  }
}

TEST(CooperativePatch, EqualsTheSerialSolutionInOneDimension) {
  expect_serial_solution_of_tents(1, 4);
}
TEST(CooperativePatch, EqualsTheSerialSolutionInTwoDimensions) {
  expect_serial_solution_of_tents(2, 3);
}
TEST(CooperativePatch, EqualsTheSerialSolutionInThreeDimensions) {
  expect_serial_solution_of_tents(3, 1);
}

/// Elements with inclined facets look for their neighbours' rigid modes and have more slots.
TEST(CooperativePatch, EqualsTheSerialSolutionOfGeneralPatches) {
  for (const int dimension : {1, 2})
    for (const GeneralKind kind : general_kinds(dimension)) {
      const TentBatch batch = general_patches(dimension, 2, kind, 1, {}, 5);
      expect_serial_solution(batch, std::string(name_of(kind)) + ", dimension " + std::to_string(dimension));
    }
}

/// Faults are found by whoever meets them and told to all.
TEST(CooperativePatch, ReportsFaultsAsOneThreadDoes) {
  TentOptions options;
  TentBatch batch = random_tents(2, 2, options, 3);
  batch.materials[0].density = std::nan("");
  const TentBatch expected = solved(batch), found = solved_together(batch, 7);
  for (std::size_t e = 0; e < found.records.size(); ++e) {
    EXPECT_NE(found.records[e].status, int(Status::ok));
    EXPECT_EQ(found.records[e].status, expected.records[e].status);
  }
}

}  // namespace
}  // namespace tentpole
