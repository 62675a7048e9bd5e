#include "device/device.hpp"

#include <cstdlib>
#include <stdexcept>

#include <omp.h>

#include "device/free_memory.hpp"
#include "device/gpu_driver.hpp"
#include "device/target_runtime.hpp"
#include "device/thread_choice.hpp"

namespace tentpole {

namespace {

const char* const way_out =
    "Install the packages clang-19, clang-tools-19 and libomp-19-dev and build with `cmake --preset virtual`, which "
    "makes a virtual device of the host's cores (and takes a GPU if there is one); or leave out --offload.";

const char* kind_name(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::host:
      return "host";
    case DeviceKind::virtual_cpu:
      return "virtual device (x86_64 image, memory of its own, the host's cores)";
    case DeviceKind::gpu:
      return "GPU (nvptx64 image)";
  }
  return "unknown device";
}

std::string why_no_device() {
  if (!target_runtime::has_device_images()) return "no device: this program was built without device images. ";
  const char* policy = std::getenv("OMP_TARGET_OFFLOAD");
  if (policy != nullptr && (policy[0] == 'D' || policy[0] == 'd'))
    return std::string("no device: the environment has OMP_TARGET_OFFLOAD=") + policy + "; unset it. ";
  return "no device: libomptarget.so, the OpenMP offloading runtime, found none that runs this program's images. ";
}

/// OpenMP lists the GPUs in the order of their driver, so the n-th GPU of one is the n-th of the other.
int gpu_number(const std::vector<Device>& devices, int device_number) {
  int gpu = 0;
  for (const Device& device : devices) gpu += device.kind == DeviceKind::gpu && device.number < device_number;
  return gpu;
}

void add_driver_facts(Device& device, int gpu) {
  const std::vector<Gpu>& gpus = gpu_driver().gpus;
  if (gpu >= static_cast<int>(gpus.size())) return;
  device.name += ": " + gpus[gpu].name;
  device.num_multiprocessors = gpus[gpu].num_multiprocessors;
}

}  // namespace

Device host_device() {
  return {omp_get_initial_device(), true, DeviceKind::host, kind_name(DeviceKind::host),
          choose_threads(thread_supply(), 0).threads};
}

std::vector<Device> available_devices() {
  std::vector<Device> devices;
  for (int number = 0; number < target_runtime::num_devices(); ++number) {
    const target_runtime::Probe probe = target_runtime::probe(number);
    if (probe.ran_on_host) continue;
    Device device{number, false, probe.kind, kind_name(probe.kind), probe.num_threads};
    if (device.kind == DeviceKind::gpu) add_driver_facts(device, gpu_number(devices, number));
    devices.push_back(device);
  }
  return devices;
}

std::optional<std::int64_t> free_memory(const Device& device) {
  if (device.kind != DeviceKind::gpu) return free_host_memory();
  return free_gpu_memory(gpu_number(available_devices(), device.number));
}

std::vector<std::string> unused_gpus() {
  int num_used = 0;
  for (const Device& device : available_devices()) num_used += device.kind == DeviceKind::gpu;
  return unused_gpus(gpu_driver(), target_runtime::image_architecture(), num_used);
}

Device select_device(std::optional<int> number) {
  const std::vector<Device> devices = available_devices();
  if (devices.empty()) throw std::runtime_error(why_no_device() + way_out);
  std::string numbers;
  for (const Device& device : devices) {
    if (number ? device.number == *number : device.kind == DeviceKind::gpu) return device;
    numbers += " " + std::to_string(device.number);
  }
  if (!number) return devices.front();
  throw std::runtime_error("device " + std::to_string(*number) + " does not exist; the devices are" + numbers +
                           ". `tentpole devices` describes them.");
}

}  // namespace tentpole
