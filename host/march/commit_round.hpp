#pragma once

#include "host/march/adaptive_round.hpp"
#include "host/march/defect_search.hpp"

namespace tentpole {

/// Turns a solved round into the next front, in the order of the vertices: accepted patches are committed; the defects
/// in their new cells are tested; footprints of rejected ones and cells too large for a crack nearby are split; cracks
/// nucleate and grow. A patch above tolerance whose splits are all refused is accepted. Returns, by batch and patch,
/// what was accepted. Throws std::runtime_error with place and time for a patch that can neither be solved nor refined
/// nor shortened.
std::vector<std::vector<std::uint8_t>> commit_round(AdaptiveState& state, DefectSearch& search,
                                                    const AdaptiveRound& round);

}  // namespace tentpole
