#pragma once

#include "host/march/commit_round.hpp"
#include "host/march/front_march.hpp"
#include "host/output/crack_series.hpp"

namespace tentpole {

/// What the main loop of an adaptive run needs beside the state.
struct AdaptiveLoop {
  AdaptiveState& state;
  PatchWriter& writer;
  DefectSearch& search;
  CrackSeries& cracks;
};

/// Advances an adaptive front to the end time, round by round: plan an operation at every local minimum, solve the
/// patches on the device, accept or refine, grow cracks, book and write what is done. See FrontMarch::advance.
bool advance_adaptive_front(AdaptiveLoop& loop, const AdvanceOptions& options);

}  // namespace tentpole
