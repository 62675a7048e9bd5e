#pragma once

#include <cstddef>

#include "device/device.hpp"

namespace tentpole {

/// What moving data to a device and starting a kernel there costs; medians over repetitions.
struct DeviceRates {
  double to_device;    ///< copy rate host to device [B/s]
  double from_device;  ///< copy rate device to host [B/s]
  double launch;       ///< empty target region, start to end [s]; on the host an empty parallel region
};

/// Measures with copies of `num_bytes` (> 0), after one warm-up of each. Takes about 0.1 s on a virtual device.
DeviceRates measure_device(const Device& device, std::size_t num_bytes = std::size_t{32} << 20, int repetitions = 9);

}  // namespace tentpole
