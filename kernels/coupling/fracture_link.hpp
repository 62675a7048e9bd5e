#pragma once

#include <cmath>

#include "kernels/element/simd.hpp"
#include "kernels/launch/lanes.hpp"

namespace tentpole {

/// How waves pass a fracture facet (docs/formulation.md, Fracture facets). Both sides emit o = Z v - s and take in a =
/// s* + Z v* (own-normal tractions, per component c of the shared frame). With the intact traction on side i
///   s0_i = (Z_i o_e - Z_e o_i) / (Z_i + Z_e),     s0_1 = -s0_0,
/// the target is s*_i = W s0_i, and a_i = o_i + 2 s*_i. W is M of kernels/fracture/contact_mode.hpp in the facet's
/// modes. The amplitudes of the coupling system are y = sqrt(|F| / (2 Z)) o and x = sqrt(|F| / (2 Z)) a.
struct FractureLink {
  static constexpr int max_components = 2;
  int first[2];                         ///< first amplitude of the port on each side
  int num_components, num_modes;        ///< D, modes of a facet
  double measure;                       ///< |F|
  double normal_sign;                   ///< the own outward normal of side 0 is normal_sign times the frame's
  double impedance[2][max_components];  ///< [side][c]
  const double* map;                    ///< W, [(c, m)][(c', m')]
  double* intact;                       ///< scratch [(c, m)]: sqrt(|F|) s0 of side 0

  int size() const { return num_components * num_modes; }
  /// 1 / Z_0 + 1 / Z_1: v*_1 - v*_0 = (1 / Z_0 + 1 / Z_1) (s0 - s*) on side 0's normal.
  double compliance(int c) const { return 1 / impedance[0][c] + 1 / impedance[1][c]; }
};

/// The intact traction of side 0 in modes, from the outgoing amplitudes, into `intact` of every link; all have one
/// size.
template <class Lanes>
inline void load_intact_tractions(const FractureLink* links, int num_links, const double* outgoing,
                                  const Lanes& lanes) {
  if (num_links == 0) return;
  share(lanes, num_links, links[0].size(), [&](int index) {
    return [=, &link = links[index]](int entry) {
      const int c = entry / link.num_modes;
      const double z0 = link.impedance[0][c], z1 = link.impedance[1][c];
      const double own = outgoing[link.first[0] + entry], other = outgoing[link.first[1] + entry];
      link.intact[entry] = (z0 * sqrt(2 * z1) * other - z1 * sqrt(2 * z0) * own) / (z0 + z1);
    };
  });
  lanes.synchronize();
}

/// One entry of the target of side 0 in modes: W s0.
inline double target_entry(const FractureLink& link, int entry) {
  return dot(link.map + static_cast<long>(entry) * link.size(), link.intact, link.size());
}

/// to += E from for one entry of the two ports of a fracture facet.
inline void add_through_fracture(const FractureLink& link, int entry, const double* from, double* to) {
  const double target = target_entry(link, entry);
  for (int side = 0; side < 2; ++side) {
    const int at = link.first[side] + entry;
    const double traction = side == 0 ? target : -target;
    to[at] += from[at] + 2 * traction / sqrt(2 * link.impedance[side][entry / link.num_modes]);
  }
}

}  // namespace tentpole
