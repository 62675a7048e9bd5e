#pragma once

#include <array>
#include <span>

#include "tests/host/output/pitched_elements.hpp"

namespace tentpole {

/// u_0 = 1e-9 (1 + X Y + T^2), u_1 = 1e-9 (X^2 - 2 Y T), u_2 = 1e-9 (Z X + Y^2), with X = x / 1 mm, .., T = t / 100 ns;
/// a coordinate that the dimension lacks is 0. tests/host/output/read_back.py repeats it.
DisplacementField quadratic_field(int dimension);

/// Plane tensile waves that run from the pulled ends of a bar of this length [m] to its middle: wave speed [m/s],
/// velocity of the ends [m/s], their cubic ramp [s].
DisplacementField wave_field(double length, double speed, double velocity, double ramp);

}  // namespace tentpole
