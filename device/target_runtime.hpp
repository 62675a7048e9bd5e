#pragma once

#include <cstddef>
#include <cstdint>

#include "device/device.hpp"

namespace tentpole::target_runtime {

/// All that this folder asks of the OpenMP target runtime. Two files implement it: target_runtime.offload.cpp, and for
/// builds without device images, whose runtime may lack omp_target_alloc and its kin, target_runtime.host_only.cpp:
/// there num_devices() is 0 and calling anything else is our own mistake (std::logic_error). `device` is the OpenMP
/// number of a target device, never the host. Failures throw std::runtime_error with the device and the size.

/// Whether this build carries device images.
bool has_device_images();

/// Compute capability that this build's GPU image is made for, times ten (90 for sm_90); 0 without a GPU image.
int image_architecture();

int num_devices();

/// What a target region sent to a device found there.
struct Probe {
  bool ran_on_host;  ///< omp_is_initial_device(): the region was not run by the device
  DeviceKind kind;   ///< from the image that ran
  int num_threads;   ///< teams times threads of a default region
};
Probe probe(int device);

void* allocate(int device, std::size_t num_bytes);
void release(int device, void* address);
void copy_to(int device, void* to, const void* from, std::size_t num_bytes);
void copy_from(int device, void* to, const void* from, std::size_t num_bytes);

/// One target region that does nothing.
void launch_empty(int device);

/// One target region: to[i] = from[i] for num_words; both on the device.
void copy_words(int device, std::uint64_t* to, const std::uint64_t* from, std::int64_t num_words);

/// Rows of [slot][row_length] doubles; all pointers are to the memory of the device.
struct SlotRows {
  double* store;              ///< [slot][row_length]
  double* packed;             ///< [num_slots][row_length]
  const std::int32_t* slots;  ///< [num_slots]
  std::int64_t num_slots;
  std::int64_t row_length;
};

/// One target region each: packed[i][:] = store[slots[i]][:], and back.
void pack_rows(int device, SlotRows rows);
void unpack_rows(int device, SlotRows rows);

}  // namespace tentpole::target_runtime
