#pragma once

#include <functional>

#include "host/solver/solver_state.hpp"

namespace tentpole {

struct AdvanceOptions {
  int max_patches = 1024;  ///< per batch
  bool check = false;      ///< energy balance of every patch
  /// Called after each committed batch with the front's earliest time [s]; false stops the loop in a consistent state.
  std::function<bool(double)> after_batch = [](double) { return true; };
};

/// Advances the front to the end time: pick independent minima, pitch their tents, solve the batch on the device,
/// commit. While one batch is solved the host pitches the next. Returns false if after_batch stopped it; then every
/// pitched tent is committed, and another call goes on. When something throws, the tents that are not committed are
/// taken back, so that front and sources agree with the books unless state.is_committing; the run cannot go on then,
/// but a checkpoint can be saved.
bool advance_front(SolverState& state, const AdvanceOptions& options);

}  // namespace tentpole
