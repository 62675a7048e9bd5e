#pragma once

#include <string>

#include "host/books/run_books.hpp"
#include "tests/temporary_folder.hpp"

namespace tentpole::testing {

/// The books of a run on the host that has solved nothing yet.
class MarchBooks {
 public:
  explicit MarchBooks(const Simulation& simulation)
      : runner_(simulation, host_device(), 1, timer_, traffic_),
        recorder_(options(simulation)),
        history_(folder_.path(), 1, 1),
        ledger_(simulation, recorder_, history_),
        books_{simulation, store_, runner_, ledger_, recorder_, history_, timer_, traffic_} {}

  RunBooks& get() { return books_; }
  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  RecorderOptions options(const Simulation& simulation) const {
    RecorderOptions options;
    options.dimension = simulation.dimension();
    options.degree = simulation.degree();
    options.folder = folder_.path();
    return options;
  }

  TemporaryFolder folder_;
  StageTimer timer_;
  TrafficCounters traffic_;
  ElementStore store_;
  BatchRunner runner_;
  Recorder recorder_;
  History history_;
  Ledger ledger_;
  RunBooks books_;
};

}  // namespace tentpole::testing
