#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace tentpole {

/// What crossed the border between host and devices since construction. A batch may run on a worker thread while the
/// host reads, so each count is atomic. The host as a device moves nothing and counts nothing.
struct TrafficCounters {
  std::atomic<std::int64_t> bytes_to_device{0};
  std::atomic<std::int64_t> bytes_from_device{0};
  std::atomic<std::int64_t> launches{0};  ///< target regions

  /// One target region was launched; structs passed by value (firstprivate) travel to the device, `num_bytes` in all.
  /// Single numbers and pointers ride in the launch itself and count nothing. Whoever launches calls this.
  void count_launch(std::size_t num_bytes = 0) {
    ++launches;
    bytes_to_device += static_cast<std::int64_t>(num_bytes);
  }
};

}  // namespace tentpole
