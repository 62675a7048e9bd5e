#include "device/gather_slots.hpp"

#include <cassert>
#include <cstring>

#include "device/target_runtime.hpp"

namespace tentpole {

namespace {

const double* row_of(const double* store, std::int32_t slot, std::int64_t row_length) {
  return store + slot * row_length;
}

std::size_t row_bytes(std::int64_t row_length) {
  return static_cast<std::size_t>(row_length) * sizeof(double);
}

}  // namespace

SlotTransfer::SlotTransfer(const Device& device, TrafficCounters& traffic)
    : traffic_(traffic), slots_(device, traffic), packed_(device, traffic) {}

void SlotTransfer::gather(const DeviceBuffer<double>& store, std::int64_t row_length,
                          std::span<const std::int32_t> slots, std::span<double> rows) {
  assert(std::ssize(rows) == std::ssize(slots) * row_length && "rows holds one row for each slot");
  if (rows.empty()) return;
  const Device& device = store.device();
  if (device.is_host) {
    for (std::size_t i = 0; i < slots.size(); ++i)
      std::memcpy(rows.data() + i * row_length, row_of(store.pointer(), slots[i], row_length), row_bytes(row_length));
    return;
  }
  slots_.resize_discarding(std::ssize(slots));
  slots_.upload(slots);
  packed_.resize_discarding(std::ssize(rows));
  // pack_rows only reads the store; one struct serves both directions.
  double* const source = const_cast<double*>(store.pointer());
  target_runtime::pack_rows(device.number,
                            {source, packed_.pointer(), slots_.pointer(), std::ssize(slots), row_length});
  traffic_.count_launch(sizeof(target_runtime::SlotRows));
  packed_.download(rows);
}

void SlotTransfer::scatter(DeviceBuffer<double>& store, std::int64_t row_length, std::span<const std::int32_t> slots,
                           std::span<const double> rows) {
  assert(std::ssize(rows) == std::ssize(slots) * row_length && "rows holds one row for each slot");
  if (rows.empty()) return;
  const Device& device = store.device();
  if (device.is_host) {
    for (std::size_t i = 0; i < slots.size(); ++i)
      std::memcpy(store.pointer() + slots[i] * row_length, rows.data() + i * row_length, row_bytes(row_length));
    return;
  }
  slots_.resize_discarding(std::ssize(slots));
  slots_.upload(slots);
  packed_.resize_discarding(std::ssize(rows));
  packed_.upload(rows);
  target_runtime::unpack_rows(device.number,
                              {store.pointer(), packed_.pointer(), slots_.pointer(), std::ssize(slots), row_length});
  traffic_.count_launch(sizeof(target_runtime::SlotRows));
}

}  // namespace tentpole
