#include "device/target_runtime.hpp"

#include <stdexcept>
#include <string>

#include <omp.h>

namespace tentpole::target_runtime {

namespace {

#pragma omp declare target
/// Which compiler pass made this image.
DeviceKind image_kind() {
#ifdef __NVPTX__
  return DeviceKind::gpu;
#else
  return DeviceKind::virtual_cpu;
#endif
}
#pragma omp end declare target

void copy(int to_device, void* to, int from_device, const void* from, std::size_t num_bytes) {
  if (num_bytes == 0) return;
  if (omp_target_memcpy(to, from, num_bytes, 0, 0, to_device, from_device) == 0) return;
  throw std::runtime_error("copying " + std::to_string(num_bytes) + " bytes from device " +
                           std::to_string(from_device) + " to device " + std::to_string(to_device) + " failed");
}

}  // namespace

bool has_device_images() {
  return true;
}

int image_architecture() {
#ifdef TENTPOLE_IMAGE_ARCHITECTURE
  return TENTPOLE_IMAGE_ARCHITECTURE;
#else
  return 0;
#endif
}

int num_devices() {
  return omp_get_num_devices();
}

Probe probe(int device) {
  int on_host = 1, kind = 0, num_threads = 0;
#pragma omp target teams device(device) map(tofrom : on_host, kind, num_threads)
#pragma omp parallel
  if (omp_get_team_num() == 0 && omp_get_thread_num() == 0) {
    on_host = omp_is_initial_device();
    kind = static_cast<int>(image_kind());
    num_threads = omp_get_num_teams() * omp_get_num_threads();
  }
  return {on_host != 0, static_cast<DeviceKind>(kind), num_threads};
}

void* allocate(int device, std::size_t num_bytes) {
  void* address = omp_target_alloc(num_bytes, device);
  if (address != nullptr) return address;
  throw std::runtime_error("device " + std::to_string(device) + " has no " + std::to_string(num_bytes) +
                           " bytes of memory left");
}

void release(int device, void* address) {
  omp_target_free(address, device);
}

void copy_to(int device, void* to, const void* from, std::size_t num_bytes) {
  copy(device, to, omp_get_initial_device(), from, num_bytes);
}

void copy_from(int device, void* to, const void* from, std::size_t num_bytes) {
  copy(omp_get_initial_device(), to, device, from, num_bytes);
}

void launch_empty(int device) {
#pragma omp target parallel num_threads(1) device(device)
  {}
}

void copy_words(int device, std::uint64_t* to, const std::uint64_t* from, std::int64_t num_words) {
#pragma omp target teams distribute parallel for device(device) is_device_ptr(to, from)
  for (std::int64_t word = 0; word < num_words; ++word) to[word] = from[word];
}

// Entry fastest, so that neighbouring threads of a GPU touch neighbouring words.
void pack_rows(int device, SlotRows rows) {
#pragma omp target teams distribute parallel for collapse(2) device(device) firstprivate(rows)
  for (std::int64_t row = 0; row < rows.num_slots; ++row)
    for (std::int64_t entry = 0; entry < rows.row_length; ++entry)
      rows.packed[row * rows.row_length + entry] = rows.store[rows.slots[row] * rows.row_length + entry];
}

void unpack_rows(int device, SlotRows rows) {
#pragma omp target teams distribute parallel for collapse(2) device(device) firstprivate(rows)
  for (std::int64_t row = 0; row < rows.num_slots; ++row)
    for (std::int64_t entry = 0; entry < rows.row_length; ++entry)
      rows.store[rows.slots[row] * rows.row_length + entry] = rows.packed[row * rows.row_length + entry];
}

}  // namespace tentpole::target_runtime
