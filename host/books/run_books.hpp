#pragma once

#include "host/batch/batch_runner.hpp"
#include "host/batch/element_store.hpp"
#include "host/books/ledger.hpp"
#include "host/output/machine_info.hpp"

namespace tentpole {

/// What a run has whatever kind of front it advances: the device's side, the books and the output.
struct RunBooks {
  const Simulation& simulation;
  ElementStore& store;
  BatchRunner& runner;
  Ledger& ledger;
  Recorder& recorder;
  History& history;
  StageTimer& timer;
  TrafficCounters& traffic;
  std::int64_t earlier_fallbacks = 0;                 ///< of the run that this one resumes
  std::vector<std::string> builds{build_identity()};  ///< of the programs that have worked on the run, this one last
  bool is_committing = false;                         ///< a batch is in some of the books and not in others

  /// Patches that needed the dense solution since t = 0.
  std::int64_t num_fallbacks() const { return earlier_fallbacks + runner.num_fallbacks(); }
};

}  // namespace tentpole
