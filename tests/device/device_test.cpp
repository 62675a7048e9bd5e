#include "device/device.hpp"

#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "device/measure_device.hpp"
#include "device/target_runtime.hpp"

namespace tentpole {
namespace {

TEST(Device, HostRunsLoopsOnAtLeastOneThread) {
  const Device host = host_device();
  EXPECT_TRUE(host.is_host);
  EXPECT_EQ(host.kind, DeviceKind::host);
  EXPECT_GE(host.num_threads, 1);
}

// Guards against a build or an environment in which target regions silently run on the host: all other device tests
// would then pass without a device.
TEST(Device, BuildWithImagesHasDevicesAndBuildWithoutHasNone) {
  EXPECT_EQ(!available_devices().empty(), target_runtime::has_device_images())
      << "this program carries device images, but no target region ran on a device";
}

TEST(Device, EveryDeviceRunsItsRegionsOnItself) {
  for (const Device& device : available_devices()) {
    EXPECT_FALSE(device.is_host);
    EXPECT_NE(device.kind, DeviceKind::host);
    EXPECT_FALSE(target_runtime::probe(device.number).ran_on_host) << "device " << device.number;
    EXPECT_GE(device.num_threads, 1);
  }
}

TEST(Device, DefaultChoiceIsAGpuIfThereIsOne) {
  const std::vector<Device> devices = available_devices();
  if (devices.empty()) GTEST_SKIP() << "no device";
  bool has_gpu = false;
  for (const Device& device : devices) has_gpu = has_gpu || device.kind == DeviceKind::gpu;
  EXPECT_EQ(select_device(std::nullopt).kind, has_gpu ? DeviceKind::gpu : DeviceKind::virtual_cpu);
}

TEST(Device, ChoiceByNumberGivesThatDevice) {
  for (const Device& device : available_devices()) EXPECT_EQ(select_device(device.number).number, device.number);
}

TEST(Device, AbsentNumberIsRefusedWithTheNumbersThatExist) {
  if (available_devices().empty()) GTEST_SKIP() << "no device";
  try {
    select_device(1000);
    FAIL() << "device 1000 was accepted";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("device 1000 does not exist"), std::string::npos) << message;
    EXPECT_NE(message.find("the devices are 0"), std::string::npos) << message;
  }
}

void print_refusal_and_exit() {
  try {
    select_device(std::nullopt);
  } catch (const std::runtime_error& error) {
    std::cerr << error.what() << std::endl;
    std::exit(3);
  }
  std::exit(0);
}

// The runtime reads its environment once, when it starts: hence a child process that begins with the variable.
TEST(DeviceDeathTest, WithoutADeviceTheMessageSaysWhatToInstall) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const char* const before = std::getenv("OMP_TARGET_OFFLOAD");
  const std::string policy = before == nullptr ? "DEFAULT" : before;
  setenv("OMP_TARGET_OFFLOAD", "DISABLED", 1);
  EXPECT_EXIT(print_refusal_and_exit(), testing::ExitedWithCode(3),
              target_runtime::has_device_images()
                  ? "OMP_TARGET_OFFLOAD=DISABLED.*clang-19.*libomp-19-dev.*preset virtual"
                  : "built without device images.*clang-19.*libomp-19-dev.*preset virtual");
  setenv("OMP_TARGET_OFFLOAD", policy.c_str(), 1);
}

TEST(DeviceRates, AreOfTheOrderThatMachinesHave) {
  std::vector<Device> places = available_devices();
  places.push_back(host_device());
  for (const Device& device : places) {
    const DeviceRates rates = measure_device(device, std::size_t{1} << 20, 3);
    EXPECT_GT(rates.to_device, 1e7);
    EXPECT_LT(rates.to_device, 1e13);
    EXPECT_GT(rates.from_device, 1e7);
    EXPECT_LT(rates.from_device, 1e13);
    EXPECT_GT(rates.launch, device.num_threads > 1 ? 1e-7 : 0.0);  // a region that was optimised away takes 3e-8 s
    EXPECT_LT(rates.launch, 0.1);
  }
}

}  // namespace
}  // namespace tentpole
