#include "bench/assembly/device_update.hpp"

#include <cstdio>
#include <cstdlib>

#include <omp.h>

namespace tentpole {
namespace {

#ifdef TENTPOLE_OFFLOAD
constexpr int lanes_of_a_team = 128;  // a GPU; the kernel gets it at run time, which leaves it 128 registers

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

// Rows over teams, columns over the lanes of a team, which all run from the start (kernels/launch/launch.hpp has the
// reasons).
void add_on_gpu(const DeviceUpdate update, int device_number, int num_teams, int num_lanes) {
  const int n = update.num_unknowns;
#pragma omp target teams num_teams(num_teams) thread_limit(num_lanes) device(device_number) firstprivate(update)
#pragma omp parallel num_threads(num_lanes)
  for (int row = omp_get_team_num(); row < n; row += omp_get_num_teams()) {
    const double* trial = update.trial + row / update.num_basis * update.component_stride;
    for (int column = omp_get_thread_num(); column < n; column += omp_get_num_threads()) {
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
    add_on_gpu(update, device.number, num_threads, lanes_of_a_team);
  } else {
    add_on_cpu_device(update, device.number, num_threads);
  }
#else
  std::fputs("add_on_device: this build has no device code (preset host)\n", stderr);
  std::abort();
#endif
}

}  // namespace tentpole
