#pragma once

#include "bench/assembly/device_update.hpp"
#include "bench/assembly/element_updates.hpp"
#include "device/device_buffer.hpp"

namespace tentpole {

/// The rows of one update at a time in the memory of a device.
class DeviceRows {
 public:
  /// `traffic` must outlive the object.
  DeviceRows(const ElementUpdates& updates, const Device& device, TrafficCounters& traffic);

  /// Uploads the rows; `block` is left to the caller.
  DeviceUpdate upload(const UpdateRows& rows);

 private:
  DeviceBuffer<double> test_;
  DeviceBuffer<double> trial_;
};

}  // namespace tentpole
