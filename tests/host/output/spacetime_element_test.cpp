#include "host/output/spacetime_element.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/output/pitched_elements.hpp"
#include "tests/host/output/sample_fields.hpp"

namespace tentpole {
namespace {

TEST(ElementFields, ReproduceAQuadraticFieldAndItsDerivatives) {
  PitchedBox box;
  box.cells = {2, 2, 2};
  const PitchedElements pitched = pitch_elements(box, quadratic_field(2));
  const OrthonormalBasis basis(3, box.degree);
  const double lambda = box.material.lambda, mu = box.material.mu;
  for (const SpacetimeElement& element : pitched.elements) {
    const std::array<double, 3> event = {element.centroid()[0], element.centroid()[1], element.centroid()[2]};
    const PointFields fields = ElementFields(basis, element).at(event);
    const double x = event[0] / 1e-3, y = event[1] / 1e-3, t = event[2] / 1e-7;
    EXPECT_NEAR(fields.displacement[0], 1e-9 * (1 + x * y + t * t), 1e-21);
    EXPECT_NEAR(fields.displacement[1], 1e-9 * (x * x - 2 * y * t), 1e-21);
    EXPECT_NEAR(fields.velocity[0], 1e-2 * 2 * t, 1e-12);
    EXPECT_NEAR(fields.velocity[1], -1e-2 * 2 * y, 1e-12);
    const double exx = 1e-6 * y, eyy = -2e-6 * t, exy = 0.5e-6 * (x + 2 * x);
    EXPECT_NEAR(fields.gradient[0][1], 1e-6 * x, 1e-17);
    EXPECT_NEAR(fields.stress[0], lambda * (exx + eyy) + 2 * mu * exx, 1e-5);
    EXPECT_NEAR(fields.stress[1], lambda * (exx + eyy) + 2 * mu * eyy, 1e-5);
    EXPECT_NEAR(fields.stress[2], lambda * (exx + eyy), 1e-5);
    EXPECT_NEAR(fields.stress[3], 2 * mu * exy, 1e-5);
    EXPECT_EQ(fields.stress[4], 0);
    const double energy = 0.5 * lambda * (exx + eyy) * (exx + eyy) + mu * (exx * exx + eyy * eyy + 2 * exy * exy);
    EXPECT_NEAR(fields.strain_energy_density, energy, 1e-10);
  }
}

TEST(ElementFields, AreEqualInAllElementsThatMeetAtAPointOfAContinuousField) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    PitchedBox box;
    box.dimension = dimension;
    box.degree = dimension == 3 ? 2 : 4;
    box.cells = {2, 2, 2};
    box.end = 3e-8;
    const DisplacementField exact = quadratic_field(dimension);
    const PitchedElements pitched = pitch_elements(box, exact);
    const OrthonormalBasis basis(dimension + 1, box.degree);
    for (const SpacetimeElement& element : pitched.elements)
      for (int corner = 0; corner < dimension + 2; ++corner) {
        const auto event = std::span<const double>(element.corner[corner]).first(dimension + 1);
        const PointFields fields = ElementFields(basis, element).at(event);
        for (int i = 0; i < dimension; ++i) EXPECT_NEAR(fields.displacement[i], exact(event)[i], 1e-20);
      }
  }
}

TEST(ElementFields, UniaxialStrainHasTheFullModulusInOneDimension) {
  const DisplacementField stretch = [](std::span<const double> event) { return std::array{1e-3 * event[0], 0.0, 0.0}; };
  PitchedBox box;
  box.dimension = 1;
  box.degree = 1;
  box.cells = {1, 1, 1};
  const PitchedElements pitched = pitch_elements(box, stretch);
  const OrthonormalBasis basis(2, 1);
  const std::array<double, 2> event = {5e-4, 1e-9};
  const PointFields fields = ElementFields(basis, pitched.elements[0]).at(event);
  EXPECT_NEAR(fields.stress[0] / (1e-3 * (box.material.lambda + 2 * box.material.mu)), 1, 1e-12);
  EXPECT_NEAR(fields.stress[1] / (1e-3 * box.material.lambda), 1, 1e-12);
}

TEST(ElementFields, RefuseElementsThatDoNotFitTheBasisOrHaveNoVolume) {
  PitchedBox box;
  box.dimension = 1;
  box.cells = {1, 1, 1};
  const PitchedElements pitched = pitch_elements(box, quadratic_field(1));
  SpacetimeElement element = pitched.elements[0];
  EXPECT_THROW(ElementFields(OrthonormalBasis(3, 2), element), std::invalid_argument);
  EXPECT_THROW(ElementFields(OrthonormalBasis(2, 3), element), std::invalid_argument);
  element.corner[2] = element.corner[1];
  EXPECT_THROW(ElementFields(OrthonormalBasis(2, 2), element), std::invalid_argument);
}

}  // namespace
}  // namespace tentpole
