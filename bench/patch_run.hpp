#pragma once

#include <vector>

#include "host/batch/patch_scratch.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {

/// Whole patches (assembly, solution, post-solution) solved again and again on the host or a device, all data there.
class PatchRun {
 public:
  /// `shape`: threads, or teams of lanes on a GPU; fewer where the memory does not hold the scratch of all.
  PatchRun(TentBatch batch, const Device& device, LaunchShape shape);

  void solve();
  /// Downloads what the last solve wrote, and compares the coefficients with the polynomials the batch was made from.
  double error();
  /// Cycles of all workers in the last solve.
  StageCycles cycles() { return scratch_.total_cycles(); }
  int num_patches() const { return static_cast<int>(batch_.patches.size()); }
  const TentBatch& batch() const { return batch_; }  ///< with the records of the last error()
  int num_workers() const { return task_.shape.workers; }
  double flops() const;  ///< modelled operations of one solve, from those records

 private:
  TentBatch batch_;
  Device device_;
  DeviceTents tents_;
  PatchSolverTask task_{};
  TrafficCounters traffic_;  ///< before the scratch, which counts in it
  PatchScratch scratch_;
};

}  // namespace tentpole
