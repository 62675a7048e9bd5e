#pragma once

namespace tentpole {

/// Time stamp of the processor that runs the kernel; only ratios of differences are used.
inline long long cycle_counter() {
#if defined(__clang__)
  return static_cast<long long>(__builtin_readcyclecounter());
#else
  return static_cast<long long>(__builtin_ia32_rdtsc());
#endif
}

/// Cycles one thread (or team) spent in each stage of the patches it solved.
struct StageCycles {
  long long assembly = 0;
  long long solution = 0;
  long long post_solution = 0;
};

}  // namespace tentpole
