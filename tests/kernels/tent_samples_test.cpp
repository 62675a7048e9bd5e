#include "tests/kernels/tent_samples.hpp"

#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "kernels/reference/point_state.reference.hpp"

namespace tentpole {
namespace {

using namespace reference;

TentBatch many_tents(int dimension) {
  TentOptions options;
  options.num_patches = 20;
  options.num_materials = 2;
  options.shape = {10, 150, 0.2};
  return random_tents(dimension, 1, options, 61);
}

TEST(TentSamples, FrontsAreCausalBelowAndAbove) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    const TentBatch batch = many_tents(dimension);
    for (const ElementDescriptor& element : batch.elements) {
      const Geometry geometry = element_geometry(element, dimension);
      EXPECT_GT(geometry.determinant, 0);
      EXPECT_GT(element.corner[dimension + 1][dimension], element.corner[element.pole][dimension]);
      for (const int opposite : {dimension + 1, element.pole}) {
        const Vector covector = facet_covector(geometry, dimension, opposite);
        double slope = 0;
        for (int j = 0; j < dimension; ++j) slope += covector[j] * covector[j];
        slope = std::sqrt(slope) / covector[dimension];
        EXPECT_LT(std::abs(slope) * batch.materials[element.material].dilatational_speed(), 0.951);
        EXPECT_EQ(slope < 0, opposite == dimension + 1) << "the inflow normal points down, the outflow normal up";
      }
    }
  }
}

TEST(TentSamples, FacetsWithThePoleAreVertical) {
  for (int dimension = 1; dimension <= 3; ++dimension)
    for (const ElementDescriptor& element : many_tents(dimension).elements)
      for (int facet = 0; facet <= dimension; ++facet) {
        if (facet == element.pole) continue;
        const Vector covector = facet_covector(element_geometry(element, dimension), dimension, facet);
        EXPECT_NEAR(covector[dimension], 0, 1e-14);
      }
}

TEST(TentSamples, NeighborsShareTheirFacetCornerByCorner) {
  int num_interior = 0, num_boundary = 0;
  for (int dimension = 1; dimension <= 3; ++dimension) {
    const TentBatch batch = many_tents(dimension);
    for (int e = 0; e < static_cast<int>(batch.elements.size()); ++e) {
      const ElementDescriptor& element = batch.elements[e];
      for (int facet = 0; facet <= dimension; ++facet) {
        if (facet == element.pole) continue;
        if (element.facet_kind[facet] == FacetKind::boundary) {
          ++num_boundary;
          continue;
        }
        ++num_interior;
        const ElementDescriptor& neighbor = batch.elements[element.neighbor[facet]];
        EXPECT_EQ(neighbor.neighbor[element.neighbor_facet[facet]], e);
        EXPECT_EQ(neighbor.neighbor_facet[element.neighbor_facet[facet]], facet);
        const auto own = facet_corners(dimension, facet);
        const auto other = facet_corners(dimension, element.neighbor_facet[facet]);
        for (int c = 0; c <= dimension; ++c)
          for (int j = 0; j <= dimension; ++j) EXPECT_EQ(element.corner[own[c]][j], neighbor.corner[other[c]][j]);
      }
    }
  }
  EXPECT_GT(num_interior, 100);
  EXPECT_GT(num_boundary, 20);
}

TEST(TentSamples, ThePoleTakesEveryPlaceAmongTheCorners) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    std::set<int> poles;
    for (const ElementDescriptor& element : many_tents(dimension).elements) poles.insert(element.pole);
    EXPECT_EQ(static_cast<int>(poles.size()), dimension + 1);
  }
}

TEST(TentSamples, AnglesOfAFanLieInTheRange) {
  std::mt19937 generator(4);
  for (int trial = 0; trial < 50; ++trial) {
    const TentGeometry tent = fan_star(trial % 2 == 0, 5, 150, generator);
    double sum = 0;
    for (const auto& cell : tent.cells) {
      std::vector<double> direction;
      for (int c = 0; c < 3; ++c)
        if (cell[c] != tent.pole)
          direction.push_back(std::atan2(tent.position[cell[c]][1] - tent.position[tent.pole][1],
                                         tent.position[cell[c]][0] - tent.position[tent.pole][0]));
      double angle = std::abs(direction[0] - direction[1]) * 180 / std::numbers::pi;
      angle = std::min(angle, 360 - angle);
      EXPECT_GT(angle, 5 - 1e-9);
      EXPECT_LT(angle, 150 + 1e-9);
      sum += angle;
    }
    if (trial % 2 == 0)
      EXPECT_LT(sum, 330);
    else
      EXPECT_NEAR(sum, 360, 1e-9);
  }
}

TEST(TentSamples, TheStateBelowIsThePolynomialOfTheElement) {
  // Velocity and strain given below equal those of the exact coefficients on the inflow facet, from sources and initial
  // data.
  TentOptions options;
  options.num_patches = 4;
  for (int dimension = 1; dimension <= 3; ++dimension) {
    TentBatch batch = random_tents(dimension, 2, options, 62);
    const Discretization disc(dimension, 2);
    for (std::size_t e = 0; e < batch.elements.size(); ++e) {
      const ElementDescriptor& element = batch.elements[e];
      const Row barycentric = facet_barycentric(disc, 1);
      const PointState below = state_below(disc, batch.view(), element, dimension + 1, barycentric);
      const Row xi = element_point(barycentric, facet_corners(dimension, dimension + 1));
      const PointState own = evaluate(
          point_state(disc, element_geometry(element, dimension).inverse, batch.materials[element.material], xi),
          &batch.exact[e * disc.num_unknowns]);
      for (int i = 0; i < dimension; ++i) EXPECT_NEAR(below.velocity[i][0], own.velocity[i][0], 1e-10);
      for (int ij = 0; ij < dimension * dimension; ++ij) EXPECT_NEAR(below.stress[ij][0], own.stress[ij][0], 1e-10);
    }
  }
}

TEST(TentSamples, TheSameSeedGivesTheSameBatch) {
  const TentBatch first = many_tents(2), second = many_tents(2);
  EXPECT_EQ(first.prescribed, second.prescribed);
  EXPECT_EQ(first.exact, second.exact);
}

}  // namespace
}  // namespace tentpole
