#pragma once

#include <cmath>

namespace tentpole {

/// What one patch did with energy, scaled: change = work - loss up to rounding.
struct PatchEnergies {
  double change = 0;   ///< through outflow minus through inflow facets
  double loss = 0;     ///< numerical dissipation, fracture and friction
  double work = 0;     ///< of loads
  double largest = 0;  ///< energy, work or loss of one element or fracture facet; at least what makes rounding of the
                       ///< initial displacement negligible (energy_balance.cpp)

  double imbalance() const { return std::fabs(change + loss - work); }
};

}  // namespace tentpole
