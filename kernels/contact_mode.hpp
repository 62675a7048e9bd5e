#pragma once

#include <cmath>

#include "kernels/damage_law.hpp"

namespace tentpole {

/// How the debonded part of a fracture facet bears load at a point.
enum class ContactMode : int { open = 0, stick = 1, slip = 2 };

/// s* = M s0 at a point, in the components (normal, tangential) of the frame: the bonded part 1 - D carries the intact
/// traction, the debonded part D nothing (open), the same (stick), or the normal part and the friction that it allows
/// (slip, against `direction` = sign of the intact tangential traction).
struct TractionMap {
  double normal;      ///< s*_n / s0_n
  double tangential;  ///< s*_t / s0_t
  double friction;    ///< s*_t / s0_n
};

/// D = 1 has no tangential component. `normal_sign`: the own normal of side 0 is normal_sign times the frame's.
inline TractionMap traction_map(const FractureLaw& law, ContactMode mode, double damage, double direction,
                                double normal_sign) {
  switch (mode) {
    case ContactMode::open:
      return {1 - damage, 1 - damage, 0};
    case ContactMode::stick:
      return {1, 1, 0};
    default:
      return {1, 1 - damage, -damage * law.friction * direction * normal_sign};
  }
}

/// Open while the sides are apart, or where the bond would be in tension; otherwise stuck while friction holds.
/// Tolerances (scaled units, stress rho0 c0^2, length h0) keep rounding from opening a surface that merely touches.
///   normal, tangential: intact traction on the own normal of side 0 (tension positive).
inline ContactMode contact_mode(const FractureLaw& law, double gap, double normal, double tangential) {
  constexpr double gap_tolerance = 1e-10, traction_tolerance = 1e-12;
  if (gap > gap_tolerance || normal > traction_tolerance) return ContactMode::open;
  return fabs(tangential) <= law.friction * fabs(normal) ? ContactMode::stick : ContactMode::slip;
}

}  // namespace tentpole
