#pragma once

#include <functional>
#include <vector>

#include "host/output/checkpoint_file.hpp"
#include "host/output/run_summary.hpp"
#include "host/output/written_files.hpp"

namespace tentpole {

struct AdvanceOptions {
  int max_patches = 1024;  ///< per batch
  bool check = false;      ///< energy balance of every patch, invariants of the front
  /// Called after each committed batch with the front's earliest time [s]; false stops the loop in a consistent state.
  std::function<bool(double)> after_batch = [](double) { return true; };
};

/// How a run advances its front: on a fixed mesh (fixed_march.hpp) or with refinement and fracture
/// (host/march/adaptive_march.hpp).
class FrontMarch {
 public:
  virtual ~FrontMarch() = default;

  /// Advances the front to the end time. Returns false if after_batch stopped it; then every pitched patch is committed
  /// or given up, and another call goes on. When something throws, front and books agree unless
  /// RunBooks::is_committing; the run cannot go on then, but a checkpoint can be saved.
  virtual bool advance(const AdvanceOptions& options) = 0;

  virtual int num_cells() const = 0;

  /// Counts that only this kind of front has.
  virtual void fill(RunSummary& summary) = 0;

  /// Writes the front and which element (row) lies below each cell; returns the slots of the rows.
  virtual std::vector<std::int32_t> save(CheckpointContents& contents) const = 0;

  /// Restores it in a march that has not begun and acquires a slot for every row; returns them. Throws
  /// std::runtime_error, with the reason, where the contents do not fit.
  virtual std::vector<std::int32_t> load(const CheckpointContents& contents) = 0;

  /// The files that only this kind of front writes, so far.
  virtual void add_written(WrittenFiles&) const {}
};

}  // namespace tentpole
