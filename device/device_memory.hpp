#pragma once

#include <cstddef>

#include "device/device.hpp"
#include "device/traffic_counters.hpp"

namespace tentpole {

/// Bytes on one device, aligned to 64 (a cache line, and the widest vector). Owns them; move only. The address is valid
/// in kernels on that device alone, and on the host if the device is the host. This is the untyped base of
/// DeviceBuffer; it does not know what the bytes mean.
class DeviceMemory {
 public:
  static constexpr std::size_t alignment = 64;

  /// Throws std::runtime_error, with the device and the size, if the device has no such memory left.
  DeviceMemory(const Device& device, std::size_t num_bytes);
  ~DeviceMemory();
  DeviceMemory(DeviceMemory&& other) noexcept;
  DeviceMemory& operator=(DeviceMemory&& other) noexcept;

  std::byte* pointer() const { return aligned_; }
  std::size_t num_bytes() const { return num_bytes_; }

 private:
  bool is_host_;
  int number_;
  std::size_t num_bytes_;
  void* allocated_ = nullptr;
  std::byte* aligned_ = nullptr;
};

/// Copies from the host to `to` on the device, and counts the bytes; plain uncounted memcpy if the device is the host.
void copy_to_device(const Device& device, void* to, const void* from, std::size_t num_bytes, TrafficCounters& traffic);

/// Copies from `from` on the device to the host, and counts the bytes; plain uncounted memcpy if the device is the
/// host.
void copy_from_device(const Device& device, void* to, const void* from, std::size_t num_bytes,
                      TrafficCounters& traffic);

/// Copies between places that do not overlap on one device, both aligned to 8 bytes and num_bytes a multiple of 8. On a
/// target device by a kernel (one launch): omp_target_memcpy within the virtual device goes through host memory.
void copy_on_device(const Device& device, void* to, const void* from, std::size_t num_bytes, TrafficCounters& traffic);

}  // namespace tentpole
