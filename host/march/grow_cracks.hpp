#pragma once

#include "host/march/refinement.hpp"

namespace tentpole {

/// Goes on with unfinished surfaces, then turns triggers into new ones, in the order in which they came. First the
/// place is refined, where its cell is larger than limits.crack_size. A crack tip within limits.growth_length is
/// extended; a crack within it gets a branch if the direction differs enough; otherwise a new crack begins at the
/// nearest vertex, with an arm to each side. An extension, a branch and an arm are growth_length long, whatever the
/// cells. What is not admissible now waits for later rounds.
void grow_cracks(AdaptiveState& state, Refinement& refinement);

}  // namespace tentpole
