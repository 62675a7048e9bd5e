#pragma once

#include <vector>

#include "host/fracture/fragments.hpp"
#include "host/march/adaptive_state.hpp"

namespace tentpole {

/// Sizes of the front as a row of history.csv shows them. SI. Fragments are counted by their cells.
FrontState front_state(const AdaptiveState& state);

/// The fracture surfaces of the front. SI.
struct SurfaceState {
  double crack_length = 0;    ///< [m^(D-1)], with damage >= 0.999
  double surface_length = 0;  ///< [m^(D-1)], all of them
  double damage_mean = 0;
  double damage_max = 0;
};
SurfaceState surface_state(const AdaptiveState& state);

/// The parts into which separating edges cut the front, with mass and momentum of the solution on it. SI. Reads the
/// elements below the front from the device.
std::vector<RunSummary::Fragment> fragments_in_motion(AdaptiveState& state);

}  // namespace tentpole
