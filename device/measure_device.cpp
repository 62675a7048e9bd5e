#include "device/measure_device.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <vector>

#include "device/device_buffer.hpp"
#include "device/target_runtime.hpp"

namespace tentpole {

namespace {

/// Median time of one call [s], after a warm-up call.
template <class Function>
double median_seconds(int repetitions, Function function) {
  function();
  std::vector<double> seconds;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    function();
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::nth_element(seconds.begin(), seconds.begin() + repetitions / 2, seconds.end());
  return seconds[repetitions / 2];
}

void launch(const Device& device) {
  if (!device.is_host) return target_runtime::launch_empty(device.number);
#pragma omp parallel
  std::atomic_signal_fence(std::memory_order_seq_cst);  // compilers delete a parallel region without effects
}

}  // namespace

DeviceRates measure_device(const Device& device, std::size_t num_bytes, int repetitions) {
  TrafficCounters traffic;
  std::vector<std::uint8_t> on_host(num_bytes, 1);
  DeviceBuffer<std::uint8_t> buffer(device, traffic, static_cast<std::int64_t>(num_bytes));
  const double up = median_seconds(repetitions, [&] { buffer.upload(on_host); });
  const double down = median_seconds(repetitions, [&] { buffer.download(on_host); });
  const double start = median_seconds(100 * repetitions, [&] { launch(device); });
  const double size = static_cast<double>(num_bytes);
  return {size / up, size / down, start};
}

}  // namespace tentpole
