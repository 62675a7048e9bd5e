#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "device/gather_slots.hpp"
#include "tests/device/target_observer.hpp"

namespace tentpole {
namespace {

/// Without a device each loop below would be empty and prove nothing.
class Traffic : public testing::Test {
  void SetUp() override { ASSERT_FALSE(available_devices().empty()); }
};

/// Runs `operation` and holds what it counted against what the OpenMP runtime reported of it.
void expect_counted_as_observed(TrafficCounters& traffic, const std::function<void()>& operation) {
  ASSERT_TRUE(is_observing()) << "the OpenMP runtime reports nothing: run through ctest, or set LD_LIBRARY_PATH to the "
                                 "folder of libomp.so";
  const std::int64_t to = traffic.bytes_to_device, from = traffic.bytes_from_device, launches = traffic.launches;
  const ObservedTraffic before = observed_traffic();
  operation();
  const ObservedTraffic after = observed_traffic();
  EXPECT_EQ(traffic.bytes_to_device - to, after.bytes_to_device - before.bytes_to_device);
  EXPECT_EQ(traffic.bytes_from_device - from, after.bytes_from_device - before.bytes_from_device);
  EXPECT_EQ(traffic.launches - launches, after.launches - before.launches);
}

TEST_F(Traffic, UploadsAndDownloadsAreCountedAsTheRuntimeSeesThem) {
  for (const Device& device : available_devices()) {
    TrafficCounters traffic;
    DeviceBuffer<double> buffer(device, traffic, 100);
    std::vector<double> values(100, 1.5);
    expect_counted_as_observed(traffic, [&] { buffer.upload(values); });
    EXPECT_EQ(traffic.bytes_to_device, 800);
    expect_counted_as_observed(traffic, [&] { buffer.download(std::span(values).first(10), 3); });
    EXPECT_EQ(traffic.bytes_from_device, 80);
    EXPECT_EQ(traffic.launches, 0);
  }
}

TEST_F(Traffic, GrowthCrossesNoBorder) {
  for (const Device& device : available_devices()) {
    TrafficCounters traffic;
    DeviceBuffer<double> buffer(device, traffic, 100);
    expect_counted_as_observed(traffic, [&] { buffer.grow_keeping(150); });
    EXPECT_EQ(traffic.bytes_to_device, 0);
    EXPECT_EQ(traffic.bytes_from_device, 0);
    EXPECT_EQ(traffic.launches, 1);
  }
}

TEST_F(Traffic, GatherMovesSlotsAndRowsInOneLaunch) {
  for (const Device& device : available_devices()) {
    TrafficCounters traffic;
    DeviceBuffer<double> store(device, traffic, 50 * 40);
    SlotTransfer transfer(device, traffic);
    const std::vector<std::int32_t> slots{3, 1, 49};
    std::vector<double> rows(3 * 40);
    expect_counted_as_observed(traffic, [&] { transfer.gather(store, 40, slots, rows); });
    EXPECT_EQ(traffic.bytes_from_device, 3 * 40 * 8);
    EXPECT_LT(traffic.bytes_to_device, 100);  // 12 bytes of slots and the launch argument
    EXPECT_EQ(traffic.launches, 1);
    expect_counted_as_observed(traffic, [&] { transfer.scatter(store, 40, slots, rows); });
    EXPECT_EQ(traffic.launches, 2);
  }
}

// A mapped variable keeps the value it had when it was mapped: on the host, or with shared memory, the region would
// see 2.
TEST_F(Traffic, VirtualDeviceHasMemoryOfItsOwn) {
  for (const Device& device : available_devices()) {
    if (device.kind != DeviceKind::virtual_cpu) continue;
    int value = 1, seen = 0;
    const int number = device.number;
#pragma omp target enter data map(to : value) device(number)
    value = 2;
#pragma omp target parallel num_threads(1) map(alloc : value) map(from : seen) device(number)
    seen = value;
#pragma omp target exit data map(delete : value) device(number)
    EXPECT_EQ(seen, 1);
  }
}

}  // namespace
}  // namespace tentpole
