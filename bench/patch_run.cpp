#include "bench/patch_run.hpp"

#include <utility>

#include "bench/sample_patches.hpp"

namespace tentpole {

PatchRun::PatchRun(TentBatch batch, const Device& device, LaunchShape shape)
    : batch_(std::move(batch)), device_(device), tents_(batch_, device), scratch_(device, traffic_, shape) {
  task_.batch = tents_.view();
  task_.tables = tents_.tables();
}

void PatchRun::solve() {
  scratch_.prepare(batch_.patches, task_);
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

double PatchRun::flops() const {
  double flops = 0;
  for (std::size_t e = 0; e < batch_.elements.size(); ++e) {
    int ports = 0;
    for (int facet = 0; facet <= batch_.dimension + 1; ++facet)
      ports += is_shared(batch_.elements[e].facet_kind[facet]);
    flops += flops_per_element(tents_.tables(), ports, batch_.records[e].num_iterations);
  }
  return flops;
}

}  // namespace tentpole
