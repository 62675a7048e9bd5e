#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "tests/kernels/cracked_tents.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

/// Dimension and degree.
class FractureEnergy : public testing::TestWithParam<std::tuple<int, int>> {
 protected:
  int dimension() const { return std::get<0>(GetParam()); }
  int degree() const { return std::get<1>(GetParam()); }
  /// Cracks under the pressure (negative: tension) in tents about 0.5 high.
  TentBatch breaking_tents(double relaxation_time, const CrackState& state, double pressure) const {
    TentOptions options;
    options.num_patches = degree() == 4 ? 3 : 8;
    const auto batch = [&](double amount) {
      return cracked_tents(dimension(), degree(), options, state, 40 + 10 * dimension() + degree(), amount);
    };
    TentBatch tents = batch(pressure);
    tents.fracture_law = breaking_law(batch(-4), relaxation_time);
    return tents;
  }
};

/// Tents of half a relaxation time to five, cracks that open and cracks under pressure that slide.
TEST_P(FractureEnergy, BalancesWhileDamageGrows) {
  double growth = 0, friction = 0, rounds = 0;
  int facets = 0;
  for (const double relaxation_time : {1.0, 0.1})
    for (const double pressure : {-4.0, 0.0, 2.0})
      for (const double damage : {0.0, 0.7}) {
        const TentBatch batch = solved(breaking_tents(relaxation_time, {damage, 0}, pressure));
        for (const PatchDescriptor& patch : batch.patches) {
          const ElementRecord& first = batch.records[patch.first_element];
          ASSERT_EQ(first.status, int(Status::ok)) << status_name(Status(first.status)) << " after "
                                                   << batch.fracture_records[patch.first_fracture].rounds << " rounds";
          const CrackedBalance balance = balance_with_cracks(batch, patch);
          EXPECT_NEAR(balance.closure / balance.largest, 0, 1e-12);
          friction += balance.friction;
        }
        for (const FractureRecord& record : batch.fracture_records) {
          growth = std::max(growth, record.largest_damage_change);
          rounds += record.rounds;
          ++facets;
        }
      }
  EXPECT_GT(growth, 0.3);
  EXPECT_TRUE(dimension() == 1 || degree() == 1 || friction > 0);
  EXPECT_LT(rounds / facets, 9);
}

TEST_P(FractureEnergy, DissipatesOnEverySide) {
  for (const double pressure : {-4.0, 0.0, 2.0}) {
    const TentBatch batch = solved(breaking_tents(0.3, {0.3, 0}, pressure));
    for (const ElementRecord& record : batch.records) {
      EXPECT_EQ(record.status, int(Status::ok)) << status_name(Status(record.status));
      EXPECT_GE(record.dissipation, 0);
    }
    for (const FractureRecord& record : batch.fracture_records) {
      EXPECT_GE(record.fracture_work, 0);
      EXPECT_GE(record.friction_work, 0);
    }
  }
}

TEST_P(FractureEnergy, DamageGrowsMonotonicallyToOneAtMost) {
  for (const double relaxation_time : {1.0, 0.01}) {
    const TentBatch batch = solved(breaking_tents(relaxation_time, {0.2, 0}, -4));
    const int lines = dimension() == 1 ? 1 : degree() + 1;
    double largest = 0;
    for (std::size_t f = 0; f < batch.fracture_records.size(); ++f) {
      const FractureRecord& record = batch.fracture_records[f];
      for (int line = 0; line < lines; ++line) {
        EXPECT_GE(record.damage[line], batch.fracture_facets[f].damage[line] - 1e-15);
        EXPECT_LE(record.damage[line], 1);
        largest = std::max(largest, record.damage[line]);
      }
    }
    EXPECT_GT(largest, 0.25);
  }
}

INSTANTIATE_TEST_SUITE_P(DimensionsAndDegrees, FractureEnergy,
                         testing::Combine(testing::Values(1, 2), testing::Values(1, 2, 3, 4)));

}  // namespace
}  // namespace tentpole
