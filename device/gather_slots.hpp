#pragma once

#include <cstdint>
#include <span>

#include "device/device_buffer.hpp"

namespace tentpole {

/// Moves chosen rows of a [slot][row_length] array of doubles between a device and contiguous host memory. Rows are
/// packed on the device by one kernel and cross the border in one copy; the slot numbers go up in another (4 bytes a
/// row). Keeps its scratch between calls. One object serves one device and one thread at a time.
class SlotTransfer {
 public:
  /// `traffic` must outlive the object.
  SlotTransfer(const Device& device, TrafficCounters& traffic);

  /// rows[i][:] = store[slots[i]][:]. rows has slots.size() * row_length entries; slots may repeat.
  void gather(const DeviceBuffer<double>& store, std::int64_t row_length, std::span<const std::int32_t> slots,
              std::span<double> rows);

  /// store[slots[i]][:] = rows[i][:]. Slots must differ from each other.
  void scatter(DeviceBuffer<double>& store, std::int64_t row_length, std::span<const std::int32_t> slots,
               std::span<const double> rows);

 private:
  TrafficCounters& traffic_;
  DeviceBuffer<std::int32_t> slots_;
  DeviceBuffer<double> packed_;
};

}  // namespace tentpole
