#pragma once

#include "host/march/adaptive_state.hpp"

namespace tentpole {

/// Throws std::runtime_error, naming the first fault, unless everything that a checkpoint restores beside the front
/// fits the front: lengths, indices, codes and finite numbers.
void require_sound_state(const AdaptiveState& state);

}  // namespace tentpole
