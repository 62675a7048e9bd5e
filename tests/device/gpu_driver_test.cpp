#include "device/gpu_driver.hpp"

#include <gtest/gtest.h>

namespace tentpole {
namespace {

GpuDriver driver_of(int architecture) {
  GpuDriver driver;
  driver.is_installed = true;
  driver.library = "/usr/lib/libcuda.so.1";
  driver.has_plain_name = true;
  driver.gpus = {{"Sample GPU", architecture, 132, 80'000'000'000}};
  return driver;
}

/// The only reason that is given.
std::string reason(const GpuDriver& driver, int image_architecture, int num_used = 0) {
  const std::vector<std::string> reasons = unused_gpus(driver, image_architecture, num_used);
  EXPECT_EQ(reasons.size(), 1u);
  return reasons.empty() ? "" : reasons[0];
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << part << " is missing in: " << text;
}

TEST(UnusedGpus, AreNoneWithoutADriverOrWhereAllAreUsed) {
  EXPECT_TRUE(unused_gpus({}, 90, 0).empty());
  EXPECT_TRUE(unused_gpus(driver_of(90), 90, 1).empty());
}

TEST(UnusedGpus, OfABuildWithoutAnImageAskForAToolkit) {
  expect_parts(reason(driver_of(90), 0),
               {"GPU 0 (Sample GPU) is not used", "no nvptx image", "ptxas", "-DTENTPOLE_GPU_ARCH=sm_90"});
}

TEST(UnusedGpus, OfAnotherArchitectureNameBothAndTheOption) {
  expect_parts(reason(driver_of(80), 90), {"is 8.0", "is for 9.0", "-DTENTPOLE_GPU_ARCH=sm_80"});
  expect_parts(reason(driver_of(100), 90), {"is 10.0", "-DTENTPOLE_GPU_ARCH=sm_100"});
  expect_parts(reason(driver_of(86), 89), {"is 8.6", "is for 8.9"});
}

TEST(UnusedGpus, WithoutThePlainNameOfTheLibrarySayHowToMakeIt) {
  GpuDriver driver = driver_of(90);
  driver.has_plain_name = false;
  expect_parts(reason(driver, 90),
               {"opens libcuda.so", "ln -s /usr/lib/libcuda.so.1 ~/cuda/libcuda.so", "LD_LIBRARY_PATH"});
}

TEST(UnusedGpus, OfADriverThatDoesNotStartSayWhyAndWhatMustWorkFirst) {
  GpuDriver driver;
  driver.is_installed = true;
  driver.failure = "it does not start: no CUDA-capable device is detected";
  expect_parts(reason(driver, 90), {"no CUDA-capable device is detected", "nvidia-smi"});
}

TEST(UnusedGpus, ThatTheRuntimeLeavesOutForNoReasonWeKnowSayWhereToLook) {
  expect_parts(reason(driver_of(90), 90), {"does not list it", "LIBOMPTARGET_INFO", "older than LLVM 22"});
}

TEST(GpuDriver, IsAskedOnceAndAnswersWithoutAGpuToo) {
  const GpuDriver& driver = gpu_driver();
  EXPECT_EQ(&driver, &gpu_driver());
  if (driver.gpus.empty()) {
    EXPECT_FALSE(driver.failure.empty());
  }
  for (std::size_t gpu = 0; gpu < driver.gpus.size(); ++gpu) {
    EXPECT_GT(driver.gpus[gpu].num_multiprocessors, 0);
    EXPECT_LE(free_gpu_memory(static_cast<int>(gpu)).value_or(0), driver.gpus[gpu].num_bytes);
  }
  EXPECT_FALSE(free_gpu_memory(1000).has_value());
}

}  // namespace
}  // namespace tentpole
