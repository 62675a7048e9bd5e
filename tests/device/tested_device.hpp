#pragma once

#include <optional>
#include <vector>

#include "device/device.hpp"

namespace tentpole {

/// The device that tests run on besides the host: a GPU if there is one, as for runs, or else the virtual device;
/// nothing in a build without device images.
inline std::optional<Device> tested_device() {
  if (available_devices().empty()) return std::nullopt;
  return select_device(std::nullopt);
}

/// Lanes of a team there: one warp of a GPU; a CPU device solves patches by threads that are alone.
inline int tested_lanes(const Device& device) {
  return device.kind == DeviceKind::gpu ? 32 : 1;
}

/// Workers of the launches that tests try there: two, which take many items each, and on a GPU also as many teams as
/// runs keep resident.
inline std::vector<int> tested_workers(const Device& device) {
  if (device.kind != DeviceKind::gpu) return {2};
  return {2, 16 * (device.num_multiprocessors > 0 ? device.num_multiprocessors : 132)};
}

/// Awkward numbers of items for loops over them, and on a GPU one that no lane of tested_workers() goes without.
inline std::vector<int> tested_counts(const Device& device) {
  if (device.kind != DeviceKind::gpu) return {0, 1, 513};
  return {0, 1, 513, tested_workers(device).back() * tested_lanes(device) + 1};
}

}  // namespace tentpole
