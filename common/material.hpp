#pragma once

#include <cmath>

namespace tentpole {

/// Isotropic linear elastic material as the kernels see it. sigma = lambda tr(E) I + 2 mu E in the D dimensions at
/// hand: D = 1 is uniaxial strain (modulus lambda + 2 mu); D = 2 plane stress enters through lambda* = 2 lambda mu /
/// (lambda + 2 mu). Units: SI on the host [kg/m^3, Pa]; the solver scales to density rho0 and stress rho0 c_p^2
/// (docs/formulation.md, Scaling).
struct Material {
  double density;
  double lambda;
  double mu;

  double dilatational_speed() const { return std::sqrt((lambda + 2 * mu) / density); }
  double shear_speed() const { return std::sqrt(mu / density); }
};

}  // namespace tentpole
