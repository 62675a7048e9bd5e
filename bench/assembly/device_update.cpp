#include "bench/assembly/device_update.hpp"

#include <cstdio>
#include <cstdlib>

namespace tentpole {
namespace {

#ifdef TENTPOLE_OFFLOAD
void add_on_cpu_device(const DeviceUpdate update, int device_number, int num_threads) {
  const int n = update.num_unknowns;
#pragma omp target teams num_teams(1) device(device_number) firstprivate(update)
#pragma omp parallel for num_threads(num_threads) schedule(static)
  for (int row = 0; row < n; ++row) {
    // Vectorised where the image has vectors; a simd pragma would be an error in the image of a GPU, which never runs
    // this.
    double* __restrict entries = update.block + static_cast<long>(row) * n;
    const double* __restrict trial = update.trial + row / update.num_basis * update.component_stride;
    for (int term = 0; term < update.num_terms; ++term, trial += n) {
      const double factor = update.weight * update.test[static_cast<long>(term) * n + row];
      for (int column = 0; column < n; ++column) entries[column] += factor * trial[column];
    }
  }
}

void add_on_gpu(const DeviceUpdate update, int device_number, int num_teams) {
  const int n = update.num_unknowns;
#pragma omp target teams distribute num_teams(num_teams) device(device_number) firstprivate(update)
  for (int row = 0; row < n; ++row) {
#pragma omp parallel for
    for (int column = 0; column < n; ++column) {
      const double* trial = update.trial + row / update.num_basis * update.component_stride;
      double sum = 0;
      for (long term = 0; term < update.num_terms; ++term)
        sum += update.test[term * n + row] * trial[term * n + column];
      update.block[static_cast<long>(row) * n + column] += update.weight * sum;
    }
  }
}
#endif

}  // namespace

void add_on_device([[maybe_unused]] const DeviceUpdate& update, [[maybe_unused]] const Device& device,
                   [[maybe_unused]] int num_threads) {
#ifdef TENTPOLE_OFFLOAD
  if (device.kind == DeviceKind::gpu) {
    add_on_gpu(update, device.number, num_threads);
  } else {
    add_on_cpu_device(update, device.number, num_threads);
  }
#else
  std::fputs("add_on_device: this build has no device code (preset host)\n", stderr);
  std::abort();
#endif
}

}  // namespace tentpole
