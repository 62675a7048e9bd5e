#pragma once

#include <vector>

#include "device/device.hpp"

namespace tentpole {

/// The host and every target device of this build.
inline std::vector<Device> places() {
  std::vector<Device> result = available_devices();
  result.insert(result.begin(), host_device());
  return result;
}

}  // namespace tentpole
