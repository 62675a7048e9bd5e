#pragma once

#include <array>

namespace tentpole {

/// A symmetric stress in the plane; tension is positive. Any unit.
struct PlaneStress {
  double xx, yy, xy;
};

/// A unit normal in the plane; a surface with this normal runs along (-y, x).
using PlaneNormal = std::array<double, 2>;

/// The surface through a point that bears the largest effective traction
///   s_eff = sqrt(<s_n>_+^2 + beta^2 s_t^2)     (thesis 2.6).
struct EffectiveTractionMaximum {
  double effective_traction;
  double normal_traction;          ///< s_n on that surface; negative where shear of a compressed surface is decisive
  double tangential_traction;      ///< |s_t| on it
  int num_orientations;            ///< 1 or 2; 2: mirrored at the principal axes, equally loaded
  PlaneNormal normal[2];           ///< of each; the sign of a normal has no meaning
  bool every_orientation = false;  ///< both principal stresses are equal, so the normal is arbitrary
};

/// Closed form over all orientations. With the mean m and radius r > 0 of Mohr's circle and c = cos 2 theta, theta the
/// angle from the axis of the larger principal stress, s_n = m + r c and s_t^2 = r^2 (1 - c^2). The maximum is at
///   m > 0, beta <= 1 or m >= r (beta^2 - 1):  c = 1, the principal direction;
///   m > 0 otherwise:                          c = m / (r (beta^2 - 1)), two mirrored directions;
///   m <= 0:                                   c = 0, pure shear with s_n = m, if beta r > m + r, else c = 1.
/// The last line goes beyond the first two, which hold for surfaces in tension: (2.6) counts the shear of compressed
/// surfaces in full, and the damage law does, too. Pressure alone gives 0.
EffectiveTractionMaximum maximal_effective_traction(const PlaneStress& stress, double shear_factor);

/// One dimension: the only surface bears <stress>_+.
double maximal_effective_traction(double stress);

}  // namespace tentpole
