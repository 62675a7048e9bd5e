#include "bench/patch_run.hpp"

#include <utility>

#include "bench/sample_patches.hpp"

namespace tentpole {
namespace {

constexpr int gpu_lanes = 128;

}  // namespace

PatchRun::PatchRun(TentBatch batch, const Device& device, int workers)
    : batch_(std::move(batch)),
      device_(device),
      tents_(batch_, device),
      scratch_(device, traffic_),
      cycles_(device, traffic_) {
  task_.batch = tents_.view();
  task_.tables = tents_.tables();
  task_.shape = {workers, device.kind == DeviceKind::gpu ? gpu_lanes : 1};
  task_.scratch_stride = patch_scratch_size(task_.tables, batch_.patches, task_.shape.lanes);
  scratch_.resize_discarding(task_.scratch_stride * workers);
  cycles_.resize_discarding(workers);
  cycles_.upload(std::vector<StageCycles>(workers));
  task_.scratch = scratch_.pointer();
  task_.cycles = cycles_.pointer();
}

void PatchRun::solve() {
  if (device_.is_host) {
    solve_patches_host(task_);
  } else {
    solve_patches_device(task_, device_.number);
  }
}

double PatchRun::error() {
  tents_.download(batch_);
  return polynomial_error(batch_, static_cast<int>(batch_.elements.size()));
}

}  // namespace tentpole
