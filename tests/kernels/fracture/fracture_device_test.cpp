#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "tests/device/tested_device.hpp"
#include "tests/kernels/cracked_tents.hpp"
#include "tests/kernels/device_tents.hpp"
#include "tests/kernels/solved_together.hpp"

namespace tentpole {
namespace {

/// Cracks that break, close and slide, in patches beside others that have none.
TentBatch sample(int dimension, int degree, int num_patches) {
  TentOptions options;
  options.num_patches = num_patches;
  const auto tents = [&](double pressure) {
    return cracked_tents(dimension, degree, options, {0.3, 0}, 7 * dimension + degree, pressure);
  };
  TentBatch batch = tents(dimension == 1 ? -4 : 0.5);
  batch.fracture_law = breaking_law(tents(-4), 0.3);
  return batch;
}

void expect_equal(const TentBatch& left, const TentBatch& right) {
  EXPECT_LT(difference_of_solutions(left, right), 1e-9);
  ASSERT_EQ(left.fracture_records.size(), right.fracture_records.size());
  for (std::size_t f = 0; f < left.fracture_records.size(); ++f) {
    const FractureRecord &a = left.fracture_records[f], &b = right.fracture_records[f];
    EXPECT_EQ(a.status, int(Status::ok));
    EXPECT_EQ(b.status, int(Status::ok));
    EXPECT_EQ(a.rounds, b.rounds);
    for (int line = 0; line <= left.degree; ++line) {
      EXPECT_NEAR(a.damage[line], b.damage[line], 1e-11);
      EXPECT_NEAR(a.gap[line], b.gap[line], 1e-11);
    }
    EXPECT_NEAR(a.fracture_work, b.fracture_work, 1e-11);
    EXPECT_NEAR(a.friction_work, b.friction_work, 1e-11);
    EXPECT_NEAR(a.largest_effective_traction, b.largest_effective_traction, 1e-10);
    for (int mode = 0; mode < 3; ++mode) EXPECT_EQ(a.mode_points[mode], b.mode_points[mode]);
  }
}

class FractureOn : public testing::TestWithParam<int> {};

TEST_P(FractureOn, AnyNumberOfThreadsGivesTheSameBits) {
  const TentBatch batch = sample(GetParam(), 2, 20), expected = solved(batch),
                  found = solved(batch, host_device(), {3, 1});
  const auto equal = [](const auto& a, const auto& b) {
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
  };
  EXPECT_TRUE(equal(found.coefficients, expected.coefficients));
  EXPECT_TRUE(equal(found.records, expected.records));
  EXPECT_TRUE(equal(found.fracture_records, expected.fracture_records));
}

/// Patches without fracture facets do not notice that others of their batch have some.
TEST_P(FractureOn, OtherPatchesDoNotNotice) {
  TentBatch cracked = sample(GetParam(), 2, 6), intact = without_cracks(cracked);
  PatchDescriptor& first = cracked.patches[0];
  for (int e = first.first_element; e < first.first_element + first.num_elements; ++e)
    cracked.elements[e] = intact.elements[e];
  first.num_fractures = 0;
  const TentBatch found = solved(cracked), expected = solved(intact);
  for (int e = first.first_element; e < first.first_element + first.num_elements; ++e)
    EXPECT_EQ(std::memcmp(&found.records[e], &expected.records[e], sizeof(ElementRecord)), 0);
}

TEST_P(FractureOn, ADeviceEqualsTheHost) {
  const std::optional<Device> device = tested_device();
  if (!device) GTEST_SKIP() << "no device in this build";
  for (int degree = 1; degree <= 4; ++degree) {
    const TentBatch batch = sample(GetParam(), degree, 5);
    expect_equal(solved(batch), solved(batch, *device, {2, tested_lanes(*device)}));
  }
}

TEST_P(FractureOn, LanesThatShareAPatchEqualOneThread) {
  for (int degree = 1; degree <= 3; ++degree) {
    const TentBatch batch = sample(GetParam(), degree, 2), expected = solved(batch);
    for (const int lanes : {1, 2, 7, 32}) expect_equal(expected, solved_together(batch, lanes));
  }
}

/// Coefficients found by other means are judged with the damage that they cause.
TEST_P(FractureOn, EvaluationRepeatsTheRecordsOfTheSolution) {
  for (int degree = 1; degree <= 3; ++degree) {
    const TentBatch expected = solved(sample(GetParam(), degree, 4));
    TentBatch again = expected;
    again.records.assign(again.records.size(), {});
    again.fracture_records.assign(again.fracture_records.size(), {});
    const ReferenceTables tables(again.dimension, again.degree);
    evaluate_patches_host(again.view(), tables.view());
    for (std::size_t e = 0; e < again.records.size(); ++e) {
      EXPECT_EQ(again.records[e].status, int(Status::ok));
      EXPECT_LT(again.records[e].residual, 1e-9);
      EXPECT_NEAR(again.records[e].dissipation, expected.records[e].dissipation, 1e-9);
    }
    for (std::size_t f = 0; f < again.fracture_records.size(); ++f) {
      EXPECT_NEAR(again.fracture_records[f].fracture_work, expected.fracture_records[f].fracture_work, 1e-9);
      EXPECT_NEAR(again.fracture_records[f].damage[0], expected.fracture_records[f].damage[0], 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, FractureOn, testing::Values(1, 2));

/// Where damage jumps from nothing to everything at one traction, often no damage fits the traction that it causes.
/// Such patches say so, the others of the batch are solved.
TEST(FractureLoop, APatchThatDoesNotSettleSaysSo) {
  TentOptions options;
  options.num_patches = 20;
  TentBatch batch = cracked_tents(2, 3, options, {0, 0}, 113, -4);
  batch.fracture_law = breaking_law(batch, 0.1);
  batch.fracture_law.threshold *= 3.5;
  batch.fracture_law.strength = batch.fracture_law.threshold * (1 + 1e-9);
  batch = solved(batch);
  int failed = 0, settled = 0;
  for (const PatchDescriptor& patch : batch.patches) {
    const Status status = static_cast<Status>(batch.records[patch.first_element].status);
    EXPECT_TRUE(status == Status::ok || status == Status::damage_not_converged) << status_name(status);
    ++(status == Status::ok ? settled : failed);
    for (int e = patch.first_element; e < patch.first_element + patch.num_elements; ++e)
      EXPECT_EQ(batch.records[e].status, int(status));
    for (int f = patch.first_fracture; f < patch.first_fracture + patch.num_fractures; ++f)
      EXPECT_EQ(batch.fracture_records[f].status, int(status));
  }
  EXPECT_GT(failed, 0);
  EXPECT_GT(settled, 0);
}

}  // namespace
}  // namespace tentpole
