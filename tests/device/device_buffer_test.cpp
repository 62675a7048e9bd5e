#include "device/device_buffer.hpp"

#include <cstdint>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "tests/device/places.hpp"

namespace tentpole {
namespace {

std::vector<double> counting(int size, double first) {
  std::vector<double> values(size);
  std::iota(values.begin(), values.end(), first);
  return values;
}

template <class T>
std::vector<T> contents(const DeviceBuffer<T>& buffer) {
  std::vector<T> values(buffer.size());
  buffer.download(values);
  return values;
}

TEST(DeviceBuffer, GivesBackWhatWasUploaded) {
  for (const Device& device : places())
    for (const int size : {0, 1, 7, 513}) {
      TrafficCounters traffic;
      DeviceBuffer<double> buffer(device, traffic, size);
      const std::vector<double> values = counting(size, 0.5);
      buffer.upload(values);
      EXPECT_EQ(contents(buffer), values) << device.name << ", size " << size;
    }
}

TEST(DeviceBuffer, UploadIsACopyThatLaterHostWritesDoNotReach) {
  for (const Device& device : places()) {
    TrafficCounters traffic;
    DeviceBuffer<double> buffer(device, traffic, 3);
    std::vector<double> values{1, 2, 3};
    buffer.upload(values);
    values[1] = 20;
    EXPECT_EQ(contents(buffer), (std::vector<double>{1, 2, 3})) << device.name;
  }
}

TEST(DeviceBuffer, OffsetsAddressPartsOfTheArray) {
  for (const Device& device : places()) {
    TrafficCounters traffic;
    DeviceBuffer<double> buffer(device, traffic, 6);
    buffer.upload(std::vector<double>(6, 0));
    buffer.upload(std::vector<double>{7, 8}, 3);
    EXPECT_EQ(contents(buffer), (std::vector<double>{0, 0, 0, 7, 8, 0})) << device.name;
    std::vector<double> part(2);
    buffer.download(part, 4);
    EXPECT_EQ(part, (std::vector<double>{8, 0})) << device.name;
  }
}

TEST(DeviceBuffer, StructsTravelByteByByte) {
  struct Odd {
    char letter;
    std::int32_t number;
    char tail[3];
    bool operator==(const Odd& other) const { return letter == other.letter && number == other.number; }
  };
  for (const Device& device : places()) {
    TrafficCounters traffic;
    DeviceBuffer<Odd> buffer(device, traffic, 2);
    const std::vector<Odd> values{{'a', 1, {}}, {'b', -2, {}}};
    buffer.upload(values);
    buffer.grow_keeping(5);  // an odd number of 12-byte structs is no whole number of words
    std::vector<Odd> kept(2);
    buffer.download(kept);
    EXPECT_EQ(kept, values) << device.name;
  }
}

TEST(DeviceBuffer, GrowthKeepsOldEntriesAndDoublesTheCapacity) {
  for (const Device& device : places()) {
    TrafficCounters traffic;
    DeviceBuffer<double> buffer(device, traffic, 100);
    const std::vector<double> values = counting(100, 3);
    buffer.upload(values);
    buffer.grow_keeping(101);
    EXPECT_GE(buffer.capacity(), 200);
    EXPECT_EQ(buffer.size(), 101);
    std::vector<double> kept(100);
    buffer.download(kept);
    EXPECT_EQ(kept, values) << device.name;
  }
}

TEST(DeviceBuffer, GrowingOneByOneMovesEachEntryABoundedNumberOfTimes) {
  for (const Device& device : places()) {
    TrafficCounters traffic;
    DeviceBuffer<double> buffer(device, traffic);
    for (int size = 1; size <= 1000; ++size) {
      buffer.grow_keeping(size);
      buffer.upload(std::vector<double>{1.0 * size}, size - 1);
    }
    EXPECT_EQ(contents(buffer), counting(1000, 1)) << device.name;
    EXPECT_LE(traffic.launches, 10) << "one copy on the device for each doubling";
  }
}

TEST(DeviceBuffer, DiscardingResizeKeepsTheMemoryThatSuffices) {
  for (const Device& device : places()) {
    TrafficCounters traffic;
    DeviceBuffer<double> buffer(device, traffic, 100);
    const double* const before = buffer.pointer();
    buffer.resize_discarding(10);
    EXPECT_EQ(buffer.size(), 10);
    buffer.resize_discarding(100);
    EXPECT_EQ(buffer.pointer(), before) << device.name;
    EXPECT_EQ(traffic.launches, 0);
  }
}

TEST(DeviceBuffer, IsAlignedForTheWidestVectors) {
  for (const Device& device : places())
    for (const int size : {1, 2, 3, 1000}) {
      TrafficCounters traffic;
      const DeviceBuffer<char> buffer(device, traffic, size);
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer.pointer()) % 64, 0) << device.name;
    }
}

TEST(DeviceBuffer, MovingLeavesOneOwner) {
  for (const Device& device : places()) {
    TrafficCounters traffic;
    DeviceBuffer<double> first(device, traffic, 2);
    first.upload(std::vector<double>{1, 2});
    DeviceBuffer<double> second(std::move(first));
    first = DeviceBuffer<double>(device, traffic, 1);
    EXPECT_EQ(contents(second), (std::vector<double>{1, 2})) << device.name;
  }
}

TEST(DeviceBuffer, TooMuchMemoryIsRefusedWithTheSize) {
  for (const Device& device : places()) {
    TrafficCounters traffic;
    EXPECT_THROW(DeviceBuffer<double>(device, traffic, std::int64_t{1} << 50), std::runtime_error) << device.name;
  }
}

TEST(TrafficCounters, HostMovesNothing) {
  TrafficCounters traffic;
  DeviceBuffer<double> buffer(host_device(), traffic, 8);
  buffer.upload(counting(8, 0));
  contents(buffer);
  buffer.grow_keeping(100);
  EXPECT_EQ(traffic.bytes_to_device, 0);
  EXPECT_EQ(traffic.bytes_from_device, 0);
  EXPECT_EQ(traffic.launches, 0);
}

}  // namespace
}  // namespace tentpole
