#pragma once

#include <optional>

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

}  // namespace tentpole
