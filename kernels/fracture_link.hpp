#pragma once

#include <cmath>

namespace tentpole {

/// How waves pass a fracture facet (docs/formulation.md, Fracture facets). Both sides emit o = Z v - s and take in a =
/// s* + Z v* (own-normal tractions, per component c of the shared frame). With the intact traction on side i
///   s0_i = (Z_i o_e - Z_e o_i) / (Z_i + Z_e),     s0_1 = -s0_0,
/// the target is s*_i = W s0_i, and a_i = o_i + 2 s*_i. W is M of kernels/contact_mode.hpp in the facet's modes. The
/// amplitudes of the coupling system are y = sqrt(|F| / (2 Z)) o and x = sqrt(|F| / (2 Z)) a.
struct FractureLink {
  static constexpr int max_components = 2;
  int first[2];                         ///< first amplitude of the port on each side
  int num_components, num_modes;        ///< D, modes of a facet
  double measure;                       ///< |F|
  double normal_sign;                   ///< the own outward normal of side 0 is normal_sign times the frame's
  double impedance[2][max_components];  ///< [side][c]
  const double* map;                    ///< W: [c][c'][m][m']
  double* intact;                       ///< scratch [c][m]

  /// sqrt(|F|) s0 of side 0 at component c and mode m, from the outgoing amplitudes.
  double intact_amplitude(const double* outgoing, int c, int m) const {
    const double z0 = impedance[0][c], z1 = impedance[1][c];
    const double own = outgoing[first[0] + c * num_modes + m], other = outgoing[first[1] + c * num_modes + m];
    return (z0 * sqrt(2 * z1) * other - z1 * sqrt(2 * z0) * own) / (z0 + z1);
  }
};

/// to += E from on the two ports of a fracture facet.
inline void add_through_fracture(const FractureLink& link, const double* from, double* to) {
  const int num_modes = link.num_modes;
  for (int c = 0; c < link.num_components; ++c)
    for (int m = 0; m < num_modes; ++m) link.intact[c * num_modes + m] = link.intact_amplitude(from, c, m);
  for (int c = 0; c < link.num_components; ++c)
    for (int m = 0; m < num_modes; ++m) {
      double target = 0;
      for (int other = 0; other < link.num_components; ++other) {
        const double* row = link.map + ((c * link.num_components + other) * num_modes + m) * num_modes;
        for (int n = 0; n < num_modes; ++n) target += row[n] * link.intact[other * num_modes + n];
      }
      for (int side = 0; side < 2; ++side) {
        const int entry = link.first[side] + c * num_modes + m;
        to[entry] += from[entry] + (side == 0 ? 2 : -2) * target / sqrt(2 * link.impedance[side][c]);
      }
    }
}

}  // namespace tentpole
