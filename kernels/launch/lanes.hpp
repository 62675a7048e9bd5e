#pragma once

#include <omp.h>

namespace tentpole {

/// Who works on one patch. On a CPU a single thread does; on a GPU the threads of one team share every loop over rows
/// or tiles and meet at `synchronize`. Kernels deal out their loops with `share`.
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

/// Calls work(item) for all item < num_items, dealt out to the lanes one by one. The lanes do not meet at the end.
template <class Lanes, class Work>
[[gnu::always_inline]] inline void share(const Lanes& lanes, int num_items, Work work) {
  for (int item = lanes.first(); item < num_items; item += lanes.count()) work(item);
}

/// Calls work_on(element)(item) for all element < num_elements and item < num_items, dealt out to the lanes one by one
/// with items fastest. work_on looks up what the items of an element share and returns what to do with one of them: a
/// thread that is alone does so once per element. The lanes do not meet at the end.
template <class Lanes, class WorkOn>
[[gnu::always_inline]] inline void share(const Lanes& lanes, int num_elements, int num_items, WorkOn work_on) {
  if constexpr (Lanes::cooperative) {
    for (int index = lanes.first(); index < num_elements * num_items; index += lanes.count())
      work_on(index / num_items)(index % num_items);
  } else {
    for (int element = 0; element < num_elements; ++element) {
      const auto work = work_on(element);
      for (int item = 0; item < num_items; ++item) work(item);
    }
  }
}

/// A step of the solution of a patch is a function of its own in the machine code, too. Inlined into each other the
/// steps made 8 MB of PTX, which took minutes to compile and fits no instruction cache.
#define TENTPOLE_STEP [[gnu::noinline]] inline

/// Elements of a patch that are worked on side by side: first, ..., first + count - 1.
struct ElementRange {
  int first;
  int count;
};

/// Calls work(range) until all elements of a patch had their turn: all of them at once where lanes share the work, one
/// after the other where a thread works alone and wants an element's data in its cache from one step to the next.
template <class Lanes, class Work>
[[gnu::always_inline]] inline void for_each_range(const Lanes&, int num_elements, Work work) {
  const int count = Lanes::cooperative ? num_elements : 1;
  for (int first = 0; first < num_elements; first += count) work(ElementRange{first, count});
}

}  // namespace tentpole
