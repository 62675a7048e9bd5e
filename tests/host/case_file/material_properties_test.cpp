#include "host/case_file/material_properties.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

constexpr double density = 3690, E = 260e9, nu = 0.21;

TEST(MaterialProperties, UniaxialStrainModulusInOneDimension) {
  const Material material = elastic_material({density, E, nu, Plane::strain}, 1);
  const double modulus = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  EXPECT_NEAR(material.lambda + 2 * material.mu, modulus, 1e-12 * modulus);
  EXPECT_NEAR(material.dilatational_speed(), std::sqrt(modulus / density), 1e-9);
}

TEST(MaterialProperties, PlaneStressIsTheReducedModulus) {
  const Material material = elastic_material({density, E, nu, Plane::stress}, 2);
  EXPECT_NEAR(material.lambda + 2 * material.mu, E / (1 - nu * nu), 1e-12 * E);
  EXPECT_NEAR(material.lambda, E * nu / (1 - nu * nu), 1e-12 * E);
  EXPECT_NEAR(material.mu, E / (2 * (1 + nu)), 1e-12 * E);
}

TEST(MaterialProperties, PlaneStrainAndThreeDimensionsShareTheConstants) {
  const Material strain = elastic_material({density, E, nu, Plane::strain}, 2);
  const Material solid = elastic_material({density, E, nu, Plane::stress}, 3);
  EXPECT_EQ(strain.lambda, solid.lambda);
  EXPECT_EQ(strain.mu, solid.mu);
  EXPECT_EQ(strain.density, density);
  // bulk modulus E / (3 (1 - 2 nu))
  EXPECT_NEAR(solid.lambda + 2 * solid.mu / 3, E / (3 * (1 - 2 * nu)), 1e-12 * E);
}

TEST(MaterialProperties, ThesisBarStressOfOneWave) {
  // thesis 2.4.1: pulled with 6.1 m/s, one wave carries rho c_p V = 200.5 MPa
  const Material material = elastic_material({density, E, nu, Plane::strain}, 2);
  EXPECT_NEAR(density * material.dilatational_speed() * 6.1, 200.5e6, 0.1e6);
}

}  // namespace
}  // namespace tentpole
