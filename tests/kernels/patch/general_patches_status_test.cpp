#include <cmath>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "kernels/element/element_operator.hpp"
#include "tests/kernels/device_tents.hpp"
#include "tests/kernels/general_patches.hpp"

namespace tentpole {
namespace {

void expect_status(const TentBatch& batch, Status expected) {
  const TentBatch result = solved(batch);
  for (const ElementRecord& record : result.records)
    EXPECT_EQ(record.status, int(expected)) << status_name(Status(record.status));
}

TEST(GeneralPatchStatus, TellsThatAPatchIsNotDeclaredGeneral) {
  for (const int dimension : {1, 2})
    for (const GeneralKind kind : general_kinds(dimension)) {
      TentBatch batch = general_patches(dimension, 1, kind, 1, {}, 3);
      batch.patches[0].is_general = 0;
      expect_status(batch, Status::patch_not_general);
    }
}

TEST(GeneralPatchStatus, TellsThatInclinedTentsInSpaceAreNotSolved) {
  TentOptions options;
  TentBatch batch = random_tents(3, 1, options, 2);
  batch.patches[0].is_general = 1;
  expect_status(batch, Status::ok);
  for (ElementDescriptor& element : batch.elements) element.corner[4][0] += 0.01;
  expect_status(batch, Status::patch_not_general);
}

TEST(GeneralPatchStatus, TellsThatTheNewFrontIsSteeperThanTheWaves) {
  for (const int dimension : {1, 2})
    for (const GeneralKind kind : {GeneralKind::slow_pole, GeneralKind::deletion}) {
      TentBatch batch = general_patches(dimension, 1, kind, 1, {}, 5);
      ElementDescriptor& element = batch.elements[0];
      int outflow = 0;
      while (element.facet_kind[outflow] != FacetKind::outflow) ++outflow;
      element.corner[outflow == dimension + 1 ? dimension : dimension + 1][dimension] += 50;
      expect_status(batch, Status::not_causal);
    }
}

TEST(GeneralPatchStatus, TellsThatFrontsAreUpsideDown) {
  for (const int dimension : {1, 2}) {
    TentBatch batch = general_patches(dimension, 1, GeneralKind::deletion, 1, {}, 5);
    for (ElementDescriptor& element : batch.elements)
      for (int facet = 0; facet <= dimension + 1; ++facet)
        if (element.facet_kind[facet] == FacetKind::outflow) {
          // As initial data of zeros, which only have to be somewhere.
          element.facet_kind[facet] = FacetKind::inflow;
          element.facet_data[facet] = 0;
        }
    batch.prescribed.resize(1000);
    expect_status(batch, Status::not_causal);
  }
}

TEST(GeneralPatchStatus, TellsThatThePoleLeavesTheBoundary) {
  TentBatch batch = general_patches(2, 1, GeneralKind::sliding_pole, 1, {}, 4);
  for (ElementDescriptor& element : batch.elements) element.corner[3][1] += 1e-3;
  expect_status(batch, Status::boundary_not_vertical);
}

/// Rounding tilts the facets of low tents by more than 1e-13; they stay what they are.
template <int D>
void expect_vertical_facets() {
  const ReferenceTables tables(D, 1);
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    TentOptions options;
    options.shape = {2, 170, 0.05};
    options.height_fraction = 1e-3;
    TentBatch batch = random_tents(D, 1, options, seed);
    for (const bool is_general : {false, true})
      for (const ElementDescriptor& element : batch.elements) {
        ElementOperator<D> op;
        ASSERT_EQ(build_element_operator<D>(batch.view(), tables.view(), is_general, element, op), Status::ok);
        ASSERT_EQ(op.num_inclined, 0);
        ASSERT_EQ(op.num_vertical, D);
      }
  }
}

TEST(GeneralPatchStatus, CountsNoFacetOfAStraightTentAsInclined) {
  expect_vertical_facets<1>();
  expect_vertical_facets<2>();
  expect_vertical_facets<3>();
}

}  // namespace
}  // namespace tentpole
