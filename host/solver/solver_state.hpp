#pragma once

#include "host/solver/batch_builder.hpp"
#include "host/solver/batch_runner.hpp"
#include "host/solver/ledger.hpp"

namespace tentpole {

/// What the main loop advances and a checkpoint keeps.
struct SolverState {
  const Simulation& simulation;
  Front& front;
  CellSources& sources;
  ElementStore& store;
  BatchBuilder& builder;
  BatchRunner& runner;
  Ledger& ledger;
  Recorder& recorder;
  History& history;
  StageTimer& timer;
  TrafficCounters& traffic;
  std::int64_t earlier_fallbacks = 0;  ///< of the run that this one resumes
  bool is_committing = false;          ///< a batch is in some of the books and not in others

  /// Patches that needed the dense solution since t = 0.
  std::int64_t num_fallbacks() const { return earlier_fallbacks + runner.num_fallbacks(); }
};

}  // namespace tentpole
