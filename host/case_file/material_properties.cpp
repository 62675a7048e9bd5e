#include "host/case_file/material_properties.hpp"

namespace tentpole {

Material elastic_material(const MaterialProperties& properties, int dimension) {
  const double nu = properties.poisson_ratio;
  const double mu = properties.youngs_modulus / (2 * (1 + nu));
  const double lambda = properties.youngs_modulus * nu / ((1 + nu) * (1 - 2 * nu));
  const bool plane_stress = dimension == 2 && properties.plane == Plane::stress;
  return {properties.density, plane_stress ? 2 * lambda * mu / (lambda + 2 * mu) : lambda, mu};
}

}  // namespace tentpole
