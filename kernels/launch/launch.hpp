#pragma once

#include <cstdio>
#include <cstdlib>

#include <omp.h>

namespace tentpole {

/// How a launch uses a device: `workers` threads (host, CPU device: lanes == 1), or teams of `lanes` threads (GPU: a
/// team shares a patch, and every lane takes items of its own in loops over independent items).
struct LaunchShape {
  int workers = 1;
  int lanes = 1;
};

/// Whether this is the compiler pass for a GPU. Its image holds the code of teams alone, which halves it: a kernel for
/// threads that is launched there traps, before its loop, whose schedule would take memory from the GPU's heap.
#ifdef __NVPTX__
inline constexpr bool is_gpu_image = true;
#else
inline constexpr bool is_gpu_image = false;
#endif

/// For builds without device images, where nobody may launch anything on a device.
[[noreturn]] inline void refuse_launch(const char* function) {
  std::fprintf(stderr, "%s: this build has no device code (preset host)\n", function);
  std::abort();
}

/// Calls work(item) for all item < num_items on the host, in any order; threads take `chunk` of them at a time.
template <class Work>
void loop_on_host(const LaunchShape& shape, int num_items, int chunk, const Work& work) {
#pragma omp parallel for schedule(monotonic : dynamic, chunk) num_threads(shape.workers)
  for (int item = 0; item < num_items; ++item) work(item);
}

#ifdef TENTPOLE_OFFLOAD
/// What each thread of a CPU device does in a parallel region: it calls work(item) for items that no other thread
/// takes, `chunk` of them at a time.
template <class Work>
void share_on_cpu_device(int num_items, int chunk, const Work& work) {
  if constexpr (is_gpu_image) {
    __builtin_trap();
  } else {
#pragma omp for schedule(monotonic : dynamic, chunk) nowait
    for (int item = 0; item < num_items; ++item) work(item);
  }
}

template <class Work>
void loop_on_cpu_device(const LaunchShape shape, int num_items, int chunk, const Work work, int device_number) {
  const int workers = shape.workers;  // a number travels with the launch, a struct would be mapped there and back
#pragma omp target teams num_teams(1) device(device_number) firstprivate(work)
#pragma omp parallel num_threads(workers)
  share_on_cpu_device(num_items, chunk, work);
}

// `parallel` directly inside `teams`, with no statement between them, makes all lanes run from the start (SPMD): no
// state machine, no shared stack, no heap. A number of threads that only the launch knows leaves the bound on registers
// to the compiler option (device/offload.cmake).
template <class Work>
void loop_on_gpu(const LaunchShape shape, int num_items, const Work work, int device_number) {
  const int teams = shape.workers, lanes = shape.lanes;
#pragma omp target teams num_teams(teams) thread_limit(lanes) device(device_number) firstprivate(work)
#pragma omp parallel num_threads(lanes)
  {
    const int first = omp_get_team_num() * omp_get_num_threads() + omp_get_thread_num(),
              step = omp_get_num_teams() * omp_get_num_threads();
    for (int item = first; item < num_items; item += step) work(item);
  }
}

/// The same on an OpenMP device; `work` is copied there byte by byte. Synchronous.
template <class Work>
void loop_on_device(const LaunchShape& shape, int num_items, int chunk, const Work& work, int device_number) {
  if (shape.lanes == 1)
    loop_on_cpu_device(shape, num_items, chunk, work, device_number);
  else
    loop_on_gpu(shape, num_items, work, device_number);
}
#endif

}  // namespace tentpole
