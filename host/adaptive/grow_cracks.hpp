#pragma once

#include "host/adaptive/refinement.hpp"

namespace tentpole {

/// Turns triggers into crack edges, in the order in which they came: refines the place of those whose cell is larger
/// than limits.crack_size; then a trigger beside a crack tip extends that crack by an edge, one beside the middle of a
/// crack branches off if its direction differs enough, and any other nucleates two opposite edges at the nearest
/// vertex. Triggers that find no admissible edge wait for later rounds, at most 200.
void grow_cracks(AdaptiveState& state, Refinement& refinement);

}  // namespace tentpole
