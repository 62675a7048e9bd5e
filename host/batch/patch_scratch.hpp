#pragma once

#include <optional>
#include <span>

#include "device/device_buffer.hpp"
#include "kernels/launch/patch_solver.hpp"

namespace tentpole {

/// The shape in which a device takes launches: threads that each solve whole patches on a CPU, teams of one warp on a
/// GPU, as many as are resident at once. `threads`: 0 for all of the device's.
LaunchShape device_shape(const Device& device, int threads);

/// How many of `wanted` workers with so many bytes of scratch each fit in three fifths of the free memory: the rest is
/// for the element store, which grows. Throws std::runtime_error with the figures and the way out if not even one does.
int affordable_workers(int wanted, std::int64_t bytes_per_worker, std::int64_t free_bytes, const std::string& device);

/// Scratch and cycle counters of the workers that solve patches on one device. They grow with the largest patch met;
/// large patches get fewer workers.
class PatchScratch {
 public:
  /// `memory_limit` [bytes] stands for what the device says is free, where it is given.
  PatchScratch(const Device& device, TrafficCounters& traffic, LaunchShape shape,
               std::optional<std::int64_t> memory_limit = std::nullopt);

  /// Makes room for the patches, resets the counters and fills scratch, cycles and shape of the task: no more teams
  /// than patches. Throws as affordable_workers.
  void prepare(std::span<const PatchDescriptor> patches, PatchSolverTask& task);

  /// What the workers of the last task counted, summed.
  StageCycles total_cycles();

  int num_workers() const { return num_workers_; }

 private:
  void grow(std::int64_t stride);

  Device device_;
  TrafficCounters& traffic_;
  LaunchShape shape_;
  std::optional<std::int64_t> memory_limit_;
  DeviceBuffer<double> scratch_;
  DeviceBuffer<StageCycles> cycles_;
  int num_workers_ = 0;
  std::int64_t stride_ = 0;
};

}  // namespace tentpole
