#pragma once

#include <vector>

#include "tests/kernels/device_tents.hpp"

namespace tentpole {

/// Whole patches (assembly, solution, post-solution) solved again and again on the host or a device, all data there.
class PatchRun {
 public:
  /// `workers`: threads, or teams on a GPU.
  PatchRun(TentBatch batch, const Device& device, int workers);

  void solve();
  /// Downloads the coefficients and compares them with the polynomials the batch was made from.
  double error();
  int num_patches() const { return static_cast<int>(batch_.patches.size()); }

 private:
  TentBatch batch_;
  Device device_;
  DeviceTents tents_;
  PatchSolverTask task_{};
  TrafficCounters traffic_;  ///< before the buffers, which count in it
  DeviceBuffer<double> scratch_;
  DeviceBuffer<StageCycles> cycles_;
};

}  // namespace tentpole
