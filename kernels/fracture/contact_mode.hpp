#pragma once

#include <cmath>

#include "kernels/fracture/damage_law.hpp"

namespace tentpole {

/// How the debonded part of a fracture facet bears load at a point.
enum class ContactMode : int { open = 0, stick = 1, slip = 2 };

/// Mode of a point, and for slip the sign of the intact tangential traction, which is the direction in which friction
/// acts; 0 where nothing presses.
struct ContactState {
  ContactMode mode;
  double direction;

  bool operator==(const ContactState& other) const {
    return mode == other.mode && (mode != ContactMode::slip || direction == other.direction);
  }
};

/// s* = M s0 at a point, in the components (normal, tangential) of the frame: the bonded part 1 - D carries the intact
/// traction, the debonded part D nothing (open), the same (stick), or the normal part and the friction that it allows
/// (slip).
struct TractionMap {
  double normal;      ///< s*_n / s0_n
  double tangential;  ///< s*_t / s0_t
  double friction;    ///< s*_t / s0_n
};

/// D = 1 has no tangential component. `normal_sign`: the own normal of side 0 is normal_sign times the frame's.
inline TractionMap traction_map(const FractureLaw& law, const ContactState& contact, double damage,
                                double normal_sign) {
  switch (contact.mode) {
    case ContactMode::open:
      return {1 - damage, 1 - damage, 0};
    case ContactMode::stick:
      return {1, 1, 0};
    default:
      return {1, 1 - damage, -damage * law.friction * contact.direction * normal_sign};
  }
}

/// What counts as no opening and as no tension.
struct ContactTolerance {
  double gap;
  double tension;
};

/// Both relative to the largest intact normal traction on the line of the point, so that no other scale of the load
/// enters. Tension: 5 %. Rounding alone has a sign, and a wave front of degree k >= 2 overshoots by 2 to 4 % of its
/// height ahead of itself; neither may open a surface that touches. Where tension does arrive, it opens the surface
/// with the first points that bear more, and what the others carry is a quarter of a percent in energy, in that tent
/// alone. Gap: what that traction opens during a millionth of the line, far below the distance of points and far above
/// rounding.
///   normal_compliance: 1 / Z_0 + 1 / Z_1 of the normal components; duration: of the line.
inline ContactTolerance contact_tolerance(double largest_normal, double normal_compliance, double duration) {
  return {1e-6 * largest_normal * normal_compliance * duration, 0.05 * largest_normal};
}

/// Open while the sides are apart, or where the bond would be in tension; otherwise stuck while friction holds
/// (Amontons and Coulomb).
///   normal, tangential: intact traction on the own normal of side 0 (tension positive).
inline ContactState contact_state(const FractureLaw& law, const ContactTolerance& tolerance, double gap, double normal,
                                  double tangential) {
  if (gap > tolerance.gap || normal > tolerance.tension) return {ContactMode::open, 0};
  const double pressure = normal < 0 ? -normal : 0;
  if (fabs(tangential) <= law.friction * pressure) return {ContactMode::stick, 0};
  return {ContactMode::slip, normal < 0 ? (tangential < 0 ? -1.0 : 1.0) : 0.0};
}

}  // namespace tentpole
