#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tentpole {

/// One GPU as its driver describes it.
struct Gpu {
  std::string name;
  int architecture;  ///< 90 for compute capability 9.0
  int num_multiprocessors;
  std::int64_t num_bytes;  ///< of its memory
};

/// What the driver of NVIDIA's GPUs says, which OpenMP does not ask: sizes, and why a GPU cannot be used. Read once,
/// when first asked; libcuda is opened by name, so that programs run where there is none.
struct GpuDriver {
  bool is_installed = false;    ///< libcuda.so.1 was found, or the kernel module of a GPU is loaded
  std::string library;          ///< path of libcuda.so.1; empty if it was not found
  bool has_plain_name = false;  ///< "libcuda.so" can be opened, the name that LLVM's runtime asks for
  std::string failure;          ///< why the driver does not start; empty if it does
  std::vector<Gpu> gpus;
};
const GpuDriver& gpu_driver();

/// Bytes that are free on a GPU now; nothing where the driver does not tell.
std::optional<std::int64_t> free_gpu_memory(int gpu);

/// Why GPUs that are there are not among the devices of this program, and what to do, one line each; none where there
/// is no GPU or all are used. image_architecture: of the program's nvptx image (90 for sm_90), 0 if it has none.
std::vector<std::string> unused_gpus(const GpuDriver& driver, int image_architecture, int num_used);

}  // namespace tentpole
