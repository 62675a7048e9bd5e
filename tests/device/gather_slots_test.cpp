#include "device/gather_slots.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "tests/device/places.hpp"

namespace tentpole {
namespace {

/// store[slot][entry] = 100 slot + entry.
std::vector<double> numbered_store(int num_slots, int row_length) {
  std::vector<double> store;
  for (int slot = 0; slot < num_slots; ++slot)
    for (int entry = 0; entry < row_length; ++entry) store.push_back(100 * slot + entry);
  return store;
}

TEST(SlotTransfer, GatherBringsTheRowsInTheOrderOfTheSlots) {
  for (const Device& device : places()) {
    TrafficCounters traffic;
    DeviceBuffer<double> store(device, traffic, 5 * 3);
    store.upload(numbered_store(5, 3));
    SlotTransfer transfer(device, traffic);
    std::vector<double> rows(4 * 3);
    transfer.gather(store, 3, std::vector<std::int32_t>{4, 0, 2, 2}, rows);
    EXPECT_EQ(rows, (std::vector<double>{400, 401, 402, 0, 1, 2, 200, 201, 202, 200, 201, 202})) << device.name;
  }
}

TEST(SlotTransfer, ScatterChangesTheNamedRowsAlone) {
  for (const Device& device : places()) {
    TrafficCounters traffic;
    DeviceBuffer<double> store(device, traffic, 4 * 2);
    store.upload(numbered_store(4, 2));
    SlotTransfer transfer(device, traffic);
    transfer.scatter(store, 2, std::vector<std::int32_t>{3, 1}, std::vector<double>{-1, -2, -3, -4});
    std::vector<double> all(8);
    store.download(all);
    EXPECT_EQ(all, (std::vector<double>{0, 1, -3, -4, 200, 201, -1, -2})) << device.name;
  }
}

TEST(SlotTransfer, NoSlotsMoveNothing) {
  for (const Device& device : places()) {
    TrafficCounters traffic;
    DeviceBuffer<double> store(device, traffic, 6);
    SlotTransfer transfer(device, traffic);
    transfer.gather(store, 3, {}, {});
    transfer.scatter(store, 3, {}, {});
    EXPECT_EQ(traffic.bytes_to_device, 0);
    EXPECT_EQ(traffic.bytes_from_device, 0);
    EXPECT_EQ(traffic.launches, 0);
  }
}

TEST(SlotTransfer, ScratchServesCallsOfAnySize) {
  for (const Device& device : places()) {
    TrafficCounters traffic;
    const int num_slots = 513, row_length = 40;
    DeviceBuffer<double> store(device, traffic, num_slots * row_length);
    const std::vector<double> values = numbered_store(num_slots, row_length);
    store.upload(values);
    SlotTransfer transfer(device, traffic);
    for (const int count : {1, 513, 7}) {
      std::vector<std::int32_t> slots(count);
      for (int i = 0; i < count; ++i) slots[i] = num_slots - 1 - i;
      std::vector<double> rows(count * row_length);
      transfer.gather(store, row_length, slots, rows);
      for (int i = 0; i < count; ++i)
        for (int entry = 0; entry < row_length; ++entry)
          ASSERT_EQ(rows[i * row_length + entry], values[slots[i] * row_length + entry]) << device.name;
    }
  }
}

}  // namespace
}  // namespace tentpole
