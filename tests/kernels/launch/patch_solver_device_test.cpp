#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "tests/device/tested_device.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

/// Largest difference of the coefficients of the solved elements, relative to the largest coefficient of each patch.
double coefficient_difference(const TentBatch& left, const TentBatch& right) {
  double difference = 0;
  const int n = left.num_unknowns();
  for (const PatchDescriptor& patch : left.patches) {
    double scale = 0, largest = 0;
    for (int e = patch.first_element; e < patch.first_element + patch.num_elements; ++e)
      for (int i = 0; i < n; ++i) {
        const long entry = static_cast<long>(left.elements[e].result_slot) * n + i;
        scale = std::max(scale, std::abs(left.coefficients[entry]));
        largest = std::max(largest, std::abs(left.coefficients[entry] - right.coefficients[entry]));
        if (std::isnan(right.coefficients[entry])) return right.coefficients[entry];
      }
    difference = std::max(difference, largest / scale);
  }
  return difference;
}

/// Largest difference of the numbers in the records, relative to the largest energy.
double record_difference(const TentBatch& left, const TentBatch& right) {
  double difference = 0, scale = 0;
  for (std::size_t e = 0; e < left.records.size(); ++e) {
    const ElementRecord &a = left.records[e], &b = right.records[e];
    EXPECT_EQ(a.status, int(Status::ok));
    EXPECT_EQ(b.status, int(Status::ok)) << status_name(Status(b.status));
    scale = std::max({scale, a.inflow_energy, a.outflow_energy});
    difference = std::max({difference, std::abs(a.inflow_energy - b.inflow_energy),
                           std::abs(a.outflow_energy - b.outflow_energy), std::abs(a.dissipation - b.dissipation),
                           std::abs(a.external_work - b.external_work)});
    EXPECT_NEAR(a.max_principal_stress, b.max_principal_stress, 1e-10 * (1 + std::abs(a.max_principal_stress)));
  }
  return scale > 0 ? difference / scale : 0;
}

void expect_bitwise_equal(const TentBatch& left, const TentBatch& right) {
  const auto equal = [](const auto& a, const auto& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
  };
  EXPECT_TRUE(equal(left.coefficients, right.coefficients));
  EXPECT_TRUE(equal(left.inverse_jacobians, right.inverse_jacobians));
  EXPECT_TRUE(equal(left.records, right.records));
}

TentBatch sample(int dimension, int degree, int num_patches) {
  TentOptions options;
  options.num_patches = num_patches;
  options.num_materials = 2;
  return random_tents(dimension, degree, options, 7 * dimension + degree);
}

int highest_degree(int dimension) {
  return dimension == 1 ? 7 : (dimension == 2 ? 5 : 3);
}

class PatchSolverOn : public testing::TestWithParam<int> {};

TEST_P(PatchSolverOn, AnyNumberOfThreadsGivesTheSameBits) {
  const TentBatch batch = sample(GetParam(), 2, GetParam() == 3 ? 6 : 40);
  const TentBatch expected = solved(batch);
  for (const int workers : {2, 3, 7}) expect_bitwise_equal(solved(batch, host_device(), {workers, 1}), expected);
}

TEST_P(PatchSolverOn, ASinglePatchIsSolvedAsInABatch) {
  const TentBatch batch = sample(GetParam(), 2, 5);
  const TentBatch expected = solved(batch);
  TentBatch alone = batch;
  alone.patches = {batch.patches[3]};
  alone = solved(alone);
  for (int e = batch.patches[3].first_element; e < batch.patches[3].first_element + batch.patches[3].num_elements;
       ++e) {
    const long slot = batch.elements[e].result_slot, n = batch.num_unknowns();
    EXPECT_EQ(std::memcmp(&alone.coefficients[slot * n], &expected.coefficients[slot * n], n * sizeof(double)), 0);
    EXPECT_EQ(std::memcmp(&alone.records[e], &expected.records[e], sizeof(ElementRecord)), 0);
  }
}

TEST_P(PatchSolverOn, AnEmptyBatchChangesNothing) {
  TentBatch batch = sample(GetParam(), 1, 1);
  batch.patches.clear();
  expect_bitwise_equal(solved(batch), batch);
}

/// The rest runs on a device: a GPU, or the virtual one.
class PatchSolverOnDevice : public PatchSolverOn {
 protected:
  void SetUp() override {
    const std::optional<Device> device = tested_device();
    if (!device) GTEST_SKIP() << "no device in this build";
    device_ = *device;
  }
  bool is_virtual() const { return device_.kind == DeviceKind::virtual_cpu; }

  Device device_ = host_device();
};

TEST_P(PatchSolverOnDevice, EqualsTheHostAtEveryDegree) {
  for (int degree = 1; degree <= highest_degree(GetParam()); ++degree) {
    const TentBatch batch = sample(GetParam(), degree, GetParam() == 3 ? 2 : 6);
    const TentBatch here = solved(batch), there = solved(batch, device_, {2, tested_lanes(device_)});
    EXPECT_LT(coefficient_difference(here, there), 1e-12) << "degree " << degree;
    EXPECT_LT(record_difference(here, there), 1e-12) << "degree " << degree;
  }
}

TEST_P(PatchSolverOnDevice, EqualsTheHostForAwkwardNumbersOfPatches) {
  for (const int num_patches : {0, 1, GetParam() == 3 ? 17 : 513}) {
    TentBatch batch = sample(GetParam(), 1, std::max(num_patches, 1));
    batch.patches.resize(num_patches);
    const TentBatch here = solved(batch);
    for (const int workers : tested_workers(device_)) {
      const TentBatch there = solved(batch, device_, {workers, tested_lanes(device_)});
      if (num_patches == 0) {
        expect_bitwise_equal(there, batch);
        continue;
      }
      EXPECT_LT(coefficient_difference(here, there), 1e-12);
      EXPECT_LT(record_difference(here, there), 1e-12);
    }
  }
}

TEST_P(PatchSolverOnDevice, AnyNumberOfThreadsGivesTheSameBits) {
  if (!is_virtual()) GTEST_SKIP() << "a GPU runs teams";
  const TentBatch batch = sample(GetParam(), 2, GetParam() == 3 ? 6 : 40);
  const TentBatch expected = solved(batch, device_, {1, 1});
  for (const int workers : {2, 3}) expect_bitwise_equal(solved(batch, device_, {workers, 1}), expected);
}

/// Teams of lanes share a patch, as on a GPU. The virtual device gives one team at most as many lanes as it has cores,
/// and two teams one lane each; the team's own count is what the kernel uses.
TEST_P(PatchSolverOnDevice, TeamsOfLanesEqualTheSerialPath) {
  for (int degree = 1; degree <= (GetParam() == 3 ? 2 : 3); ++degree) {
    const TentBatch batch = sample(GetParam(), degree, GetParam() == 3 ? 1 : 3);
    const TentBatch expected = solved(batch);
    for (const LaunchShape shape : {LaunchShape{1, 2}, {1, 4}, {2, 2}}) {
      const TentBatch found = solved(batch, device_, shape);
      EXPECT_LT(coefficient_difference(expected, found), 1e-12) << "degree " << degree << " lanes " << shape.lanes;
      EXPECT_LT(record_difference(expected, found), 1e-12) << "degree " << degree << " lanes " << shape.lanes;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, PatchSolverOn, testing::Values(1, 2, 3));
INSTANTIATE_TEST_SUITE_P(Dimensions, PatchSolverOnDevice, testing::Values(1, 2, 3));

}  // namespace
}  // namespace tentpole
