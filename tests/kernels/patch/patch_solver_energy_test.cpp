#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

constexpr BoundaryKind all_kinds[] = {BoundaryKind::traction, BoundaryKind::velocity, BoundaryKind::absorbing};

/// Energies of one patch.
struct PatchBalance {
  double change = 0, dissipation = 0, work = 0;
  double largest = 0;  ///< energy through a facet, or work of an element
};

PatchBalance balance_of(const TentBatch& batch, const PatchDescriptor& patch) {
  PatchBalance balance;
  for (int e = patch.first_element; e < patch.first_element + patch.num_elements; ++e) {
    const ElementRecord& record = batch.records[e];
    balance.change += record.outflow_energy - record.inflow_energy;
    balance.dissipation += record.dissipation;
    balance.work += record.external_work;
    balance.largest =
        std::max({balance.largest, record.inflow_energy, record.outflow_energy, std::abs(record.external_work)});
  }
  return balance;
}

void expect_closed_balances(const TentBatch& batch) {
  for (const PatchDescriptor& patch : batch.patches) {
    const PatchBalance balance = balance_of(batch, patch);
    ASSERT_GT(balance.largest, 0);
    EXPECT_NEAR((balance.change + balance.dissipation - balance.work) / balance.largest, 0, 1e-13)
        << "D " << batch.dimension << " k " << batch.degree;
  }
}

void expect_nonnegative_dissipation(const TentBatch& batch) {
  for (const ElementRecord& record : batch.records) {
    EXPECT_EQ(record.status, int(Status::ok)) << status_name(Status(record.status));
    EXPECT_GE(record.dissipation, 0);
  }
}

int highest_degree(int dimension) {
  return dimension == 1 ? 7 : (dimension == 2 ? 4 : 2);
}

class PatchEnergy : public testing::TestWithParam<int> {};

TEST_P(PatchEnergy, BalancesForEveryPairOfBoundaryKinds) {
  for (const BoundaryKind normal : all_kinds)
    for (const BoundaryKind tangential : all_kinds) {
      TentOptions options;
      options.num_patches = GetParam() == 3 ? 1 : 4;
      options.boundary_fraction = 1;
      options.data.normal_kind = normal;
      options.data.tangential_kind = tangential;
      const TentBatch batch = solved(random_tents(GetParam(), 2, options, 11));
      expect_closed_balances(batch);
      expect_nonnegative_dissipation(batch);
    }
}

TEST_P(PatchEnergy, BalancesOnSeveralMaterialsAtEveryDegree) {
  for (int degree = 1; degree <= highest_degree(GetParam()); ++degree) {
    TentOptions options;
    options.num_patches = GetParam() == 3 ? 1 : 5;
    options.num_materials = 3;
    const TentBatch batch = solved(random_tents(GetParam(), degree, options, 30 + degree));
    expect_closed_balances(batch);
    expect_nonnegative_dissipation(batch);
  }
}

/// Zero boundary data and no body force: no work, so energy can only be lost. The data below do not fit the boundary,
/// so some is.
TEST_P(PatchEnergy, NeverGrowsWithoutWork) {
  for (int degree = 1; degree <= highest_degree(GetParam()); ++degree) {
    TentOptions options;
    options.num_patches = GetParam() == 3 ? 1 : 5;
    options.num_materials = 2;
    options.boundary_fraction = 1;
    options.data.homogeneous = true;
    options.data.normal_kind = BoundaryKind::traction;
    options.data.tangential_kind = BoundaryKind::velocity;
    const TentBatch batch = solved(random_tents(GetParam(), degree, options, 50 + degree));
    expect_closed_balances(batch);
    expect_nonnegative_dissipation(batch);
    for (const PatchDescriptor& patch : batch.patches) {
      const PatchBalance balance = balance_of(batch, patch);
      EXPECT_NEAR(balance.work, 0, 1e-14 * balance.largest);
      EXPECT_LT(balance.change, 1e-13 * balance.largest);
    }
  }
}

/// An absorbing boundary with the far field at rest takes work out.
TEST_P(PatchEnergy, LeavesThroughAnAbsorbingBoundary) {
  TentOptions options;
  options.boundary_fraction = 1;
  options.data.homogeneous = true;
  options.data.normal_kind = options.data.tangential_kind = BoundaryKind::absorbing;
  const TentBatch batch = solved(random_tents(GetParam(), 2, options, 3));
  const PatchBalance balance = balance_of(batch, batch.patches[0]);
  EXPECT_LT(balance.work, 0);
  EXPECT_LT(balance.change, 0);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, PatchEnergy, testing::Values(1, 2, 3));

}  // namespace
}  // namespace tentpole
