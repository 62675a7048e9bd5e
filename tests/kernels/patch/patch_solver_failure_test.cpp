#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

/// Three patches of which `spoil` makes the second unsolvable.
class PatchFailure : public testing::TestWithParam<int> {
 protected:
  PatchFailure() {
    TentOptions options;
    options.num_patches = 3;
    options.boundary_fraction = 0;
    options.data.source_fraction = 0;
    batch_ = random_tents(GetParam(), GetParam() == 3 ? 1 : 2, options, 21);
    healthy_ = solved(batch_);
  }

  ElementDescriptor& spoiled_element() { return batch_.elements[batch_.patches[1].first_element + 1]; }

  /// Statuses of the second patch; all elements of a patch share one.
  Status status_of_spoiled_patch(const TentBatch& result) {
    const PatchDescriptor& patch = result.patches[1];
    for (int e = 1; e < patch.num_elements; ++e)
      EXPECT_EQ(result.records[patch.first_element + e].status, result.records[patch.first_element].status);
    return static_cast<Status>(result.records[patch.first_element].status);
  }

  void expect_other_patches_untouched(const TentBatch& result) {
    for (const int p : {0, 2})
      for (int e = batch_.patches[p].first_element;
           e < batch_.patches[p].first_element + batch_.patches[p].num_elements; ++e) {
        EXPECT_EQ(std::memcmp(&result.records[e], &healthy_.records[e], sizeof(ElementRecord)), 0);
        const long slot = batch_.elements[e].result_slot, n = batch_.num_unknowns();
        EXPECT_EQ(std::memcmp(&result.coefficients[slot * n], &healthy_.coefficients[slot * n], n * sizeof(double)), 0);
      }
  }

  void expect_status(Status expected) {
    const TentBatch result = solved(batch_);
    EXPECT_EQ(status_of_spoiled_patch(result), expected) << status_name(status_of_spoiled_patch(result));
    expect_other_patches_untouched(result);
  }

  TentBatch batch_, healthy_;
};

TEST_P(PatchFailure, IsReportedForAnElementWithoutVolume) {
  ElementDescriptor& element = spoiled_element();
  std::copy_n(element.corner[element.pole], GetParam() + 1, element.corner[GetParam() + 1]);
  expect_status(Status::inverted_element);
}

TEST_P(PatchFailure, IsReportedForATopBelowTheFront) {
  ElementDescriptor& element = spoiled_element();
  element.corner[GetParam() + 1][GetParam()] = element.corner[element.pole][GetParam()] - 0.5;
  expect_status(Status::not_causal);
}

TEST_P(PatchFailure, IsReportedForAFrontSteeperThanTheWaves) {
  ElementDescriptor& element = spoiled_element();
  const int corner = element.pole == 0 ? 1 : 0;
  element.corner[corner][GetParam()] += 50;
  expect_status(Status::not_causal);
}

TEST_P(PatchFailure, IsReportedForCornersThatAreNotNumbers) {
  spoiled_element().corner[0][0] = std::numeric_limits<double>::quiet_NaN();
  const TentBatch result = solved(batch_);
  EXPECT_NE(status_of_spoiled_patch(result), Status::ok);
  expect_other_patches_untouched(result);
}

TEST_P(PatchFailure, IsReportedForDataThatAreNotNumbers) {
  batch_.prescribed[spoiled_element().facet_data[GetParam() + 1]] = std::numeric_limits<double>::quiet_NaN();
  expect_status(Status::coupling_not_converged);
}

TEST_P(PatchFailure, IsReportedForDataThatAreInfinite) {
  batch_.prescribed[spoiled_element().facet_data[GetParam() + 1]] = std::numeric_limits<double>::infinity();
  expect_status(Status::coupling_not_converged);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, PatchFailure, testing::Values(1, 2, 3));

}  // namespace
}  // namespace tentpole
