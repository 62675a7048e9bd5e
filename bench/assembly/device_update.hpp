#pragma once

#include "device/device.hpp"

namespace tentpole {

/// One update (element_updates.hpp) whose rows and block are in the memory of a device.
struct DeviceUpdate {
  int num_basis;
  int num_unknowns;
  int num_terms;
  double weight;
  const double* test;
  const double* trial;
  long component_stride;
  double* block;  ///< [n][n]
};

/// The double loop of `vectorized` as one target region: rows over num_threads threads on a CPU device; rows over teams
/// and columns over their threads on a GPU. Synchronous. Without offload in the build it aborts: nobody may call it.
void add_on_device(const DeviceUpdate& update, const Device& device, int num_threads);

}  // namespace tentpole
