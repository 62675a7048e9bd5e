#pragma once

#include "host/march/front_march.hpp"
#include "host/march/solver_state.hpp"

namespace tentpole {

/// Advances a front on a fixed mesh to the end time: pick independent minima, pitch their tents, solve the batch on the
/// device, commit. While one batch is solved the host pitches the next. See FrontMarch::advance; when something throws,
/// the tents that are not committed are taken back.
bool advance_front(SolverState& state, const AdvanceOptions& options);

}  // namespace tentpole
