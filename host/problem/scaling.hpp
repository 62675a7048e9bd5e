#pragma once

#include "common/material.hpp"

namespace tentpole {

/// Units in which the solver works: length h0 (mean cell), time h0 / c0 (fastest wave), density rho0, stress rho0 c0^2,
/// displacement h0. With SI numbers the patch matrices are singular to working precision (docs/formulation.md,
/// Scaling). Multiply a scaled number by the unit to get SI.
struct Scaling {
  double length;   ///< [m], also of displacements
  double speed;    ///< [m/s]
  double density;  ///< [kg/m^3]
  int dimension;

  double time() const { return length / speed; }              ///< [s]
  double stress() const { return density * speed * speed; }   ///< [Pa]
  double force_density() const { return stress() / length; }  ///< [N/m^3]
  /// [J] for D = 3, per metre of each missing dimension otherwise.
  double energy() const {
    double volume = 1;
    for (int i = 0; i < dimension; ++i) volume *= length;
    return stress() * volume;
  }
  Material scaled(const Material& material) const {
    return {material.density / density, material.lambda / stress(), material.mu / stress()};
  }
};

}  // namespace tentpole
