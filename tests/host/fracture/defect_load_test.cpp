#include "host/fracture/defect_load.hpp"

#include <gtest/gtest.h>

#include "host/fracture/defect_field.hpp"

namespace tentpole {
namespace {

NucleationSettings thesis_defects(NucleationModel model) {
  NucleationSettings nucleation;
  nucleation.model = model;
  nucleation.mean = 2e9;
  nucleation.tail_strength = 400e6;
  nucleation.tail_probability = 2e-4;
  nucleation.minimum = 220e6;
  nucleation.maximum = 4e9;
  nucleation.density = 1e13;
  return nucleation;
}

TEST(DefectLoad, OfTheFieldIsAllThatALayerHolds) {
  const NucleationSettings nucleation = thesis_defects(NucleationModel::field);
  constexpr double area = 2e-7;
  EXPECT_DOUBLE_EQ(mean_defects_searched(2, nucleation, area, 4e9), 2e6);
  // Rank 1.6e-4 lies in (4^-7, 4^-6].
  EXPECT_DOUBLE_EQ(mean_defects_searched(2, nucleation, area, 400e6), 2e6 / 4096);
  EXPECT_EQ(mean_defects_searched(2, nucleation, area, 100e6), 0);
}

TEST(DefectLoad, OfTheSampledModelIsTheNumberOfTests) {
  const NucleationSettings nucleation = thesis_defects(NucleationModel::sampled);
  const double weak = StrengthDistribution::from_settings(nucleation).probability(400e6);
  EXPECT_DOUBLE_EQ(mean_defects_searched(2, nucleation, 2e-7, 400e6), 2e6 * weak);
}

}  // namespace
}  // namespace tentpole
