#pragma once

#include <omp.h>

namespace tentpole {

/// Who works on one patch. On a CPU a single thread does; on a GPU the threads of one team share every loop over rows
/// or tiles and meet at `synchronize`. Kernels loop `for (int i = lanes.first(); i < n; i += lanes.count())`.
struct SerialLane {
  static constexpr bool cooperative = false;
  static constexpr int first() { return 0; }
  static constexpr int count() { return 1; }
  static void synchronize() {}
};

/// The threads of the innermost parallel region; every one of them calls every function with the same arguments.
struct TeamLanes {
  static constexpr bool cooperative = true;
  int index;
  int size;
  int first() const { return index; }
  int count() const { return size; }
  static void synchronize() {
#pragma omp barrier
  }
};

}  // namespace tentpole
