#include "device/device_memory.hpp"

#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "device/target_runtime.hpp"

namespace tentpole {

namespace {

void* allocate_on_host(std::size_t num_bytes) {
  void* address = ::operator new(num_bytes, std::align_val_t(DeviceMemory::alignment), std::nothrow);
  if (address != nullptr) return address;
  throw std::runtime_error("the host has no " + std::to_string(num_bytes) + " bytes of memory left");
}

std::byte* align(void* address) {
  const std::uintptr_t bits = reinterpret_cast<std::uintptr_t>(address);
  const std::uintptr_t excess = bits % DeviceMemory::alignment;
  return static_cast<std::byte*>(address) + (excess == 0 ? 0 : DeviceMemory::alignment - excess);
}

}  // namespace

DeviceMemory::DeviceMemory(const Device& device, std::size_t num_bytes)
    : is_host_(device.is_host), number_(device.number), num_bytes_(num_bytes) {
  if (num_bytes == 0) return;
  // omp_target_alloc of the virtual device is malloc: 16 bytes are all it promises.
  allocated_ = is_host_ ? allocate_on_host(num_bytes) : target_runtime::allocate(number_, num_bytes + alignment);
  aligned_ = align(allocated_);
}

DeviceMemory::~DeviceMemory() {
  if (allocated_ == nullptr) return;
  if (is_host_)
    ::operator delete(allocated_, std::align_val_t(alignment));
  else
    target_runtime::release(number_, allocated_);
}

DeviceMemory::DeviceMemory(DeviceMemory&& other) noexcept
    : is_host_(other.is_host_),
      number_(other.number_),
      num_bytes_(std::exchange(other.num_bytes_, 0)),
      allocated_(std::exchange(other.allocated_, nullptr)),
      aligned_(std::exchange(other.aligned_, nullptr)) {}

DeviceMemory& DeviceMemory::operator=(DeviceMemory&& other) noexcept {
  std::swap(is_host_, other.is_host_);
  std::swap(number_, other.number_);
  std::swap(num_bytes_, other.num_bytes_);
  std::swap(allocated_, other.allocated_);
  std::swap(aligned_, other.aligned_);
  return *this;
}

void copy_to_device(const Device& device, void* to, const void* from, std::size_t num_bytes, TrafficCounters& traffic) {
  if (num_bytes == 0) return;
  if (device.is_host) {
    std::memcpy(to, from, num_bytes);
    return;
  }
  target_runtime::copy_to(device.number, to, from, num_bytes);
  traffic.bytes_to_device += static_cast<std::int64_t>(num_bytes);
}

void copy_from_device(const Device& device, void* to, const void* from, std::size_t num_bytes,
                      TrafficCounters& traffic) {
  if (num_bytes == 0) return;
  if (device.is_host) {
    std::memcpy(to, from, num_bytes);
    return;
  }
  target_runtime::copy_from(device.number, to, from, num_bytes);
  traffic.bytes_from_device += static_cast<std::int64_t>(num_bytes);
}

void copy_on_device(const Device& device, void* to, const void* from, std::size_t num_bytes, TrafficCounters& traffic) {
  if (num_bytes == 0) return;
  if (device.is_host) {
    std::memcpy(to, from, num_bytes);
    return;
  }
  target_runtime::copy_words(device.number, static_cast<std::uint64_t*>(to), static_cast<const std::uint64_t*>(from),
                             static_cast<std::int64_t>(num_bytes / 8));
  traffic.count_launch();
}

}  // namespace tentpole
