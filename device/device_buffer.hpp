#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include "device/device_memory.hpp"

namespace tentpole {

/// An array of T in the memory of one device. Owns its memory; move only. Entries start uninitialised. All traffic is
/// counted in the TrafficCounters given at construction, which must outlive the buffer. If the device is the host,
/// pointer() may be read and written directly; upload and download are then plain memcpy and are not counted.
template <class T>
class DeviceBuffer {
  static_assert(std::is_trivially_copyable_v<T>, "the device takes bytes: T must be trivially copyable");
  static_assert(alignof(T) <= DeviceMemory::alignment);

 public:
  DeviceBuffer(const Device& device, TrafficCounters& traffic, std::int64_t size = 0)
      : device_(device), traffic_(&traffic), memory_(device, bytes_for(size)), size_(size) {}

  const Device& device() const { return device_; }
  std::int64_t size() const { return size_; }
  std::int64_t capacity() const { return static_cast<std::int64_t>(memory_.num_bytes() / sizeof(T)); }

  /// Address of entry 0 on the device: for kernels, and for the host only if the device is the host. Changes when a
  /// resize grows the capacity.
  T* pointer() { return reinterpret_cast<T*>(memory_.pointer()); }
  const T* pointer() const { return reinterpret_cast<const T*>(memory_.pointer()); }

  /// `size` entries, the old ones lost. Frees the old memory before it takes the new; keeps the memory if it suffices.
  void resize_discarding(std::int64_t size) {
    assert(size >= 0);
    if (size > capacity()) {
      memory_ = DeviceMemory(device_, 0);
      memory_ = DeviceMemory(device_, bytes_for(size));
    }
    size_ = size;
  }

  /// `size` entries, the old ones kept (as many as fit). Capacity at least doubles when it must grow, so that growing
  /// one by one costs a bounded number of copies per entry; old entries are copied on the device and cross no border.
  void grow_keeping(std::int64_t size) {
    assert(size >= 0);
    if (size > capacity()) {
      DeviceMemory larger(device_, bytes_for(std::max(size, 2 * capacity())));
      copy_on_device(device_, larger.pointer(), memory_.pointer(), bytes_for(size_), *traffic_);
      memory_ = std::move(larger);
    }
    size_ = size;
  }

  /// Host `values` to entries [offset, offset + values.size()).
  void upload(std::span<const T> values, std::int64_t offset = 0) {
    assert(offset >= 0 && offset + std::ssize(values) <= size_);
    copy_to_device(device_, pointer() + offset, values.data(), values.size_bytes(), *traffic_);
  }

  /// Entries [offset, offset + values.size()) to host `values`.
  void download(std::span<T> values, std::int64_t offset = 0) const {
    assert(offset >= 0 && offset + std::ssize(values) <= size_);
    copy_from_device(device_, values.data(), pointer() + offset, values.size_bytes(), *traffic_);
  }

 private:
  /// Rounded up to whole words of 8 bytes, in which copy_on_device counts.
  static std::size_t bytes_for(std::int64_t size) { return (static_cast<std::size_t>(size) * sizeof(T) + 7) / 8 * 8; }

  Device device_;
  TrafficCounters* traffic_;
  DeviceMemory memory_;
  std::int64_t size_;
};

}  // namespace tentpole
