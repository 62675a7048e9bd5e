#pragma once

#include <vector>

#include "host/adaptive/adaptive_state.hpp"
#include "host/fracture/fragments.hpp"

namespace tentpole {

/// Cracks, counts and sizes of the front as a row of history.csv shows them. SI. Fragments are counted by their cells.
FrontState front_state(const AdaptiveState& state);

/// The fracture edges of the front for cracks_NNNN.vtkhdf. SI.
std::vector<CrackSegment> crack_segments(const AdaptiveState& state);

/// The parts into which separating edges cut the front, with mass and momentum of the solution on it. SI. Reads the
/// elements below the front from the device.
std::vector<RunSummary::Fragment> fragments_in_motion(AdaptiveState& state);

}  // namespace tentpole
