#pragma once

#include "common/material.hpp"

namespace tentpole {

/// Assumption that makes a solid two-dimensional.
enum class Plane { strain, stress };

/// Isotropic linear elastic material as the user gives it.
struct MaterialProperties {
  double density;               ///< [kg/m^3]
  double youngs_modulus;        ///< [Pa]
  double poisson_ratio;         ///< in (-1, 0.5)
  Plane plane = Plane::strain;  ///< D = 2 only
};

/// Constants of Lame, mu = E / (2 (1 + nu)), lambda = E nu / ((1 + nu) (1 - 2 nu)); for D = 2 plane stress
/// lambda* = 2 lambda mu / (lambda + 2 mu). D = 1 is uniaxial strain, modulus lambda + 2 mu. SI units.
Material elastic_material(const MaterialProperties& properties, int dimension);

}  // namespace tentpole
