#pragma once

#include <span>

#include "host/march/adaptive_state.hpp"

namespace tentpole {

/// Adds the fracture surfaces of the accepted patches ([patch]) of a solved batch to the history rows and crack files
/// whose times they cover: damage along the lines of the patch, opening as the jump of the solution.
void record_cracks(const RunBooks& books, const HostBatch& batch, std::span<const std::uint8_t> accepted,
                   CrackSeries& cracks);

}  // namespace tentpole
