#include "host/batch/patch_scratch.hpp"

#include <algorithm>
#include <stdexcept>

namespace tentpole {
namespace {

/// A team is one warp. 128 registers of each of its lanes (device/offload.cmake) keep 16 teams resident on a
/// multiprocessor.
constexpr int gpu_lanes = 32, teams_per_multiprocessor = 16;
constexpr int usual_multiprocessors = 132;  // where the driver does not tell

std::string megabytes(std::int64_t num_bytes) {
  return std::to_string((num_bytes + 999'999) / 1'000'000) + " MB";
}

}  // namespace

LaunchShape device_shape(const Device& device, int threads) {
  if (device.kind != DeviceKind::gpu) return {threads > 0 ? threads : device.num_threads, 1};
  const int multiprocessors = device.num_multiprocessors > 0 ? device.num_multiprocessors : usual_multiprocessors;
  return {teams_per_multiprocessor * multiprocessors, gpu_lanes};
}

int affordable_workers(int wanted, std::int64_t bytes_per_worker, std::int64_t free_bytes, const std::string& device) {
  const std::int64_t budget = free_bytes / 5 * 3, affordable = budget / bytes_per_worker;
  if (affordable >= 1) return static_cast<int>(std::min<std::int64_t>(wanted, affordable));
  throw std::runtime_error("one patch of this case needs " + megabytes(bytes_per_worker) +
                           " of scratch, but of the memory of " + device + " " + megabytes(free_bytes) +
                           " are free, of which 60 % may be taken. Lower discretization.degree, free memory there, or "
                           "run without --offload.");
}

PatchScratch::PatchScratch(const Device& device, TrafficCounters& traffic, LaunchShape shape,
                           std::optional<std::int64_t> memory_limit)
    : device_(device),
      traffic_(traffic),
      shape_(shape),
      memory_limit_(memory_limit),
      scratch_(device, traffic),
      cycles_(device, traffic) {}

void PatchScratch::prepare(std::span<const PatchDescriptor> patches, PatchSolverTask& task) {
  const std::int64_t stride = std::max(1L, patch_scratch_size(task.tables, patches, shape_.lanes));
  if (stride > stride_) grow(stride);
  task.shape = {num_workers_, shape_.lanes};
  if (shape_.lanes > 1 && !patches.empty()) task.shape.workers = std::min<int>(num_workers_, std::ssize(patches));
  task.scratch = scratch_.pointer();
  task.scratch_stride = stride_;
  cycles_.resize_discarding(task.shape.workers);
  cycles_.upload(std::vector<StageCycles>(task.shape.workers));
  task.cycles = cycles_.pointer();
}

void PatchScratch::grow(std::int64_t stride) {
  scratch_ = DeviceBuffer<double>(device_, traffic_);  // what it held counts as free
  const std::optional<std::int64_t> free_bytes = memory_limit_ ? memory_limit_ : free_memory(device_);
  num_workers_ = shape_.workers;
  if (free_bytes)
    num_workers_ = affordable_workers(shape_.workers, stride * std::int64_t{sizeof(double)}, *free_bytes, device_.name);
  stride_ = stride;
  scratch_.resize_discarding(stride_ * num_workers_);
}

StageCycles PatchScratch::total_cycles() {
  std::vector<StageCycles> cycles(cycles_.size());
  cycles_.download(cycles);
  StageCycles sum;
  for (const StageCycles& worker : cycles) {
    sum.assembly += worker.assembly;
    sum.solution += worker.solution;
    sum.post_solution += worker.post_solution;
  }
  return sum;
}

}  // namespace tentpole
