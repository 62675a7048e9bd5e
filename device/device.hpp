#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tentpole {

enum class DeviceKind { host, virtual_cpu, gpu };

/// One place where kernels can run. `number` is the OpenMP device number that `device(number)` clauses take.
struct Device {
  int number;    ///< >= 0 for a target device; -1 for the host, which takes no device clause
  bool is_host;  ///< kernels run as plain loops over host memory
  DeviceKind kind;
  std::string name;  ///< for people
  int num_threads;   ///< threads that a default parallel loop gets there (a GPU: teams times threads of a team)
  int num_multiprocessors = 0;  ///< of a GPU; 0 where its driver does not tell
};

/// The host itself, in every build.
Device host_device();

/// The target devices that run this program's kernels, in the order of their numbers; empty in a build without device
/// images. Each one was probed by a target region that saw omp_is_initial_device() == 0: the runtime also lists devices
/// when OMP_TARGET_OFFLOAD=DISABLED sends every region to the host, and MANDATORY does not fail without an image.
std::vector<Device> available_devices();

/// Bytes of memory that are free there now; nothing where nobody tells.
std::optional<std::int64_t> free_memory(const Device& device);

/// Why GPUs of this machine are not among available_devices(), and what to do: one sentence each.
std::vector<std::string> unused_gpus();

/// The device of that number; without a number the first GPU, or else the first virtual device.
/// Throws std::runtime_error, naming the packages and the preset to use, if there is no (such) device.
Device select_device(std::optional<int> number);

}  // namespace tentpole
