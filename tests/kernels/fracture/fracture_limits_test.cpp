#include <cmath>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "kernels/reference/point_state.reference.hpp"
#include "tests/kernels/cracked_tents.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

using namespace reference;

void expect_solved(const TentBatch& batch) {
  for (const ElementRecord& record : batch.records)
    ASSERT_EQ(record.status, int(Status::ok)) << status_name(Status(record.status));
}

/// Dimension and degree.
class FractureLimits : public testing::TestWithParam<std::tuple<int, int>> {
 protected:
  int dimension() const { return std::get<0>(GetParam()); }
  int degree() const { return std::get<1>(GetParam()); }
  TentBatch tents(const CrackState& state, double pressure = 0) const {
    TentOptions options;
    options.num_patches = 6;
    return cracked_tents(dimension(), degree(), options, state, 70 + 10 * dimension() + degree(), pressure);
  }
};

TEST_P(FractureLimits, SoundFracturesChangeNothing) {
  const TentBatch cracked = solved(tents({0, 0})), intact = solved(without_cracks(tents({0, 0})));
  expect_solved(cracked);
  EXPECT_LT(difference_of_solutions(cracked, intact), 1e-11);
  for (const FractureRecord& record : cracked.fracture_records) {
    EXPECT_NEAR(record.damage[0], 0, 1e-15);
    EXPECT_NEAR(record.fracture_work, 0, 1e-13);
    EXPECT_LE(record.rounds, 2);
  }
}

TEST_P(FractureLimits, AnOpenCrackIsABoundaryWithoutTraction) {
  const TentBatch open = solved(tents({1, 100})), cut = solved(cut_along_cracks(tents({1, 100})));
  expect_solved(open);
  EXPECT_LT(difference_of_solutions(open, cut), 1e-11);
  for (const FractureRecord& record : open.fracture_records) {
    EXPECT_GT(record.mode_points[0], 0);
    EXPECT_EQ(record.mode_points[1] + record.mode_points[2], 0);
    EXPECT_NEAR(record.fracture_work, 0, 1e-12);
  }
}

TEST_P(FractureLimits, AClosedCrackThatSticksIsIntact) {
  TentBatch cracked = tents({1, 0}, 20);
  cracked.fracture_law.friction = 0.9;
  const TentBatch stuck = solved(cracked), intact = solved(without_cracks(cracked));
  expect_solved(stuck);
  EXPECT_LT(difference_of_solutions(stuck, intact), 1e-11);
  for (const FractureRecord& record : stuck.fracture_records) {
    EXPECT_GT(record.mode_points[1], 0);
    EXPECT_EQ(record.mode_points[0] + record.mode_points[2], 0);
    EXPECT_EQ(record.gap[0], 0);
    EXPECT_LE(record.rounds, 3);
  }
}

/// The same crack half bonded lets pass half of what an intact and half of what a free surface does: the solution
/// differs from both by much.
TEST_P(FractureLimits, AHalfBondedCrackLiesBetween) {
  const TentBatch half = solved(tents({0.5, 100}));
  expect_solved(half);
  EXPECT_GT(difference_of_solutions(half, solved(without_cracks(tents({0.5, 100})))), 1e-4);
  EXPECT_GT(difference_of_solutions(half, solved(cut_along_cracks(tents({0.5, 100})))), 1e-4);
  for (const FractureRecord& record : half.fracture_records) EXPECT_GT(record.fracture_work, 0);
}

TEST_P(FractureLimits, TheOrderOfTheSidesDoesNotMatter) {
  TentBatch cracked = tents({0.6, 0}), swapped = cracked;
  for (FractureFacet& facet : swapped.fracture_facets) {
    std::swap(facet.element[0], facet.element[1]);
    std::swap(facet.facet[0], facet.facet[1]);
  }
  const TentBatch left = solved(cracked), right = solved(swapped);
  expect_solved(left);
  EXPECT_LT(difference_of_solutions(left, right), 1e-11);
  for (std::size_t f = 0; f < left.fracture_records.size(); ++f) {
    EXPECT_NEAR(left.fracture_records[f].fracture_work, right.fracture_records[f].fracture_work, 1e-11);
    EXPECT_NEAR(left.fracture_records[f].friction_work, right.fracture_records[f].friction_work, 1e-11);
    EXPECT_NEAR(left.fracture_records[f].gap[0], right.fracture_records[f].gap[0], 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(DimensionsAndDegrees, FractureLimits,
                         testing::Combine(testing::Values(1, 2), testing::Values(1, 2, 3, 4)));

/// Momentum that the elements on one side of a crack gain: int (rho v N_t - sigma N_x) over their outflow minus inflow
/// facets, which is what the crack hands to them.
std::array<double, 2> impulse(TentBatch& batch, const std::vector<int>& elements) {
  const PatchBatch view = batch.view();
  const Discretization disc(2, batch.degree);
  std::array<double, 2> sum{};
  for (const int e : elements) {
    const ElementDescriptor& element = batch.elements[e];
    const Material& material = batch.materials[element.material];
    const Geometry geometry = element_geometry(element, 2);
    for (const int facet : {element.pole, 3}) {
      const Vector covector = facet_covector(geometry, 2, facet);
      for (int q = 0; q < disc.facet_rule.num_points(); ++q) {
        const Row barycentric = facet_barycentric(disc, q);
        PointState state = state_below(disc, view, element, 3, barycentric);
        if (facet == element.pole)
          state = evaluate(point_state(disc, geometry.inverse, material,
                                       element_point(barycentric, facet_corners(2, facet_table(element, 2, facet)))),
                           &batch.coefficients[static_cast<long>(element.result_slot) * batch.num_unknowns()]);
        for (int i = 0; i < 2; ++i) {
          double flux = covector[2] * material.density * state.velocity[i][0];
          for (int j = 0; j < 2; ++j) flux -= state.stress[2 * i + j][0] * covector[j];
          sum[i] += disc.facet_rule.weights[q] * flux;
        }
      }
    }
  }
  return sum;
}

/// Halves of a body pressed together along x = 0 and moved past each other along y.
TentBatch sliding_halves(int degree, double friction, double damage) {
  TentGeometry tent;
  tent.dimension = 2;
  tent.position = {{0, -1}, {-0.9, -0.4}, {-0.8, 0.6}, {0, 0}, {0, 1.1}, {0.7, -0.5}, {1, 0.5}};
  tent.cells = {{0, 1, 3}, {1, 2, 3}, {2, 3, 4}, {0, 3, 5}, {3, 5, 6}, {3, 4, 6}};
  tent.pole = 3;
  tent.time.assign(7, 0.0);
  tent.top_time = 0.3;
  TentBatch batch;
  batch.dimension = 2;
  batch.degree = degree;
  batch.materials.assign(2, Material{1, 0.4, 0.3});
  std::vector<PolynomialField> fields(2, PolynomialField(2, degree));
  for (int half = 0; half < 2; ++half) {
    fields[half].coefficient(0, {1, 0, 0, 0}) = -0.5;
    fields[half].coefficient(1, {0, 0, 1, 0}) = half == 0 ? -1 : 1;
  }
  TentData data;
  data.homogeneous = true;
  data.source_fraction = 0;
  std::mt19937 generator(1);
  append_tent(batch, tent, {0, 0, 0, 1, 1, 1}, fields, data, generator);
  // Only the spokes along x = 0 are cracked: between an element of one half and one of the other.
  batch.patches[0].num_fractures = 0;
  for (int e = 0; e < 3; ++e)
    for (int facet = 0; facet < 4; ++facet) {
      ElementDescriptor& element = batch.elements[e];
      if (element.facet_kind[facet] != FacetKind::interior || element.neighbor[facet] < 3) continue;
      ElementDescriptor& other = batch.elements[element.neighbor[facet]];
      const int other_facet = element.neighbor_facet[facet];
      element.facet_kind[facet] = other.facet_kind[other_facet] = FacetKind::fracture;
      element.facet_data[facet] = other.facet_data[other_facet] = batch.patches[0].num_fractures++;
      FractureFacet crack{};
      crack.element[0] = e, crack.element[1] = element.neighbor[facet];
      crack.facet[0] = static_cast<std::uint8_t>(facet), crack.facet[1] = static_cast<std::uint8_t>(other_facet);
      crack.rising_end = element.pole > 3 - facet - element.pole;
      std::fill(std::begin(crack.damage), std::end(crack.damage), damage);
      batch.fracture_facets.push_back(crack);
    }
  batch.fracture_records.resize(batch.fracture_facets.size());
  batch.fracture_law = unbreakable_law();
  batch.fracture_law.friction = friction;
  return batch;
}

class FractureSlip : public testing::TestWithParam<int> {};

TEST_P(FractureSlip, CarriesTheFrictionThatThePressureAllows) {
  for (const double friction : {0.1, 0.3, 0.6}) {
    TentBatch batch = solved(sliding_halves(GetParam(), friction, 1));
    expect_solved(batch);
    ASSERT_EQ(batch.fracture_records.size(), 2u);
    double work = 0;
    for (const FractureRecord& record : batch.fracture_records) {
      EXPECT_GT(record.mode_points[2], 0);
      EXPECT_EQ(record.mode_points[0] + record.mode_points[1], 0);
      EXPECT_NEAR(record.fracture_work, 0, 1e-14);
      work += record.friction_work;
    }
    const std::array<double, 2> right = impulse(batch, {3, 4, 5}), left = impulse(batch, {0, 1, 2});
    EXPECT_GT(right[0], 0.05);
    EXPECT_NEAR(right[1], -friction * right[0], 1e-13);
    EXPECT_NEAR(left[0], -right[0], 1e-13);
    EXPECT_NEAR(left[1], -right[1], 1e-13);
    // The halves slide at about 2 less what shear waves take from either side, k_f |s_n| / Z.
    EXPECT_NEAR(work, -right[1] * (2 - 2 * friction * 0.5 / std::sqrt(0.3)), 0.12 * work);
    EXPECT_NEAR(balance_with_cracks(batch, batch.patches[0]).closure, 0, 1e-13);
  }
}

TEST_P(FractureSlip, PartlyBondedCarriesTheBondedShareOfTheShearToo) {
  TentBatch batch = sliding_halves(GetParam(), 0.2, 0.25), intact = without_cracks(batch);
  batch = solved(batch);
  expect_solved(batch);
  intact = solved(intact);
  const std::array<double, 2> part = impulse(batch, {3, 4, 5}), whole = impulse(intact, {3, 4, 5});
  EXPECT_LT(std::abs(part[1]), std::abs(whole[1]));
  EXPECT_GT(std::abs(part[1]), 0.75 * std::abs(whole[1]));
  for (const FractureRecord& record : batch.fracture_records) {
    EXPECT_GT(record.friction_work, 0);
    EXPECT_GT(record.fracture_work, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, FractureSlip, testing::Values(1, 2, 3, 4));

}  // namespace
}  // namespace tentpole
