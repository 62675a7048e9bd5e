#include "host/problem/simulation.hpp"

namespace tentpole {

FractureLaw scaled_fracture_law(const Simulation& simulation) {
  const FractureSettings& fracture = simulation.settings.fracture;
  const Scaling& scaling = simulation.scaling;
  return {fracture.threshold / scaling.stress(),
          fracture.strength / scaling.stress(),
          fracture.relaxation_time / scaling.time(),
          fracture.delay_exponent,
          fracture.shear_factor,
          fracture.friction};
}

}  // namespace tentpole
