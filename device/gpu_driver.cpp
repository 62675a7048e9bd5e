#include "device/gpu_driver.hpp"

#include <filesystem>

#include <dlfcn.h>

namespace tentpole {

namespace {

// The part of the driver's C interface that is needed (CUDA driver API, stable since version 4). Numbers instead of
// cuda.h, so that a build without a CUDA toolkit asks the same questions.
constexpr int success = 0, attribute_multiprocessors = 16, attribute_major = 75, attribute_minor = 76;
using Context = void*;
struct Functions {
  int (*initialize)(unsigned flags);
  int (*error_text)(int error, const char** text);
  int (*count)(int* count);
  int (*name)(char* name, int length, int gpu);
  int (*attribute)(int* value, int attribute, int gpu);
  int (*memory)(std::size_t* num_bytes, int gpu);
  int (*retain_context)(Context* context, int gpu);
  int (*release_context)(int gpu);
  int (*push_context)(Context context);
  int (*pop_context)(Context* context);
  int (*free_memory)(std::size_t* free, std::size_t* total);
};

const char* const driver_folders[] = {"/usr/local/nvidia/lib64", "/usr/local/nvidia/lib", "/usr/lib/x86_64-linux-gnu",
                                      "/usr/lib64", "/usr/lib/wsl/lib"};

/// Opens libcuda.so.1 by its name or where drivers put it; never closed, since LLVM's runtime uses it too.
void* open_driver() {
  if (void* library = dlopen("libcuda.so.1", RTLD_LAZY | RTLD_LOCAL)) return library;
  for (const char* folder : driver_folders)
    if (void* library = dlopen((std::string(folder) + "/libcuda.so.1").c_str(), RTLD_LAZY | RTLD_LOCAL)) return library;
  return nullptr;
}

template <class Function>
bool load(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

bool load_functions(void* library, Functions& functions) {
  return load(library, "cuInit", functions.initialize) && load(library, "cuGetErrorString", functions.error_text) &&
         load(library, "cuDeviceGetCount", functions.count) && load(library, "cuDeviceGetName", functions.name) &&
         load(library, "cuDeviceGetAttribute", functions.attribute) &&
         load(library, "cuDeviceTotalMem_v2", functions.memory) &&
         load(library, "cuDevicePrimaryCtxRetain", functions.retain_context) &&
         load(library, "cuDevicePrimaryCtxRelease_v2", functions.release_context) &&
         load(library, "cuCtxPushCurrent_v2", functions.push_context) &&
         load(library, "cuCtxPopCurrent_v2", functions.pop_context) &&
         load(library, "cuMemGetInfo_v2", functions.free_memory);
}

std::string path_of(void* function) {
  Dl_info info;
  return dladdr(function, &info) != 0 && info.dli_fname != nullptr ? info.dli_fname : "libcuda.so.1";
}

Gpu describe(const Functions& functions, int number) {
  Gpu gpu{};
  char name[256] = "";
  int major = 0, minor = 0;
  std::size_t num_bytes = 0;
  functions.name(name, sizeof name, number);
  functions.attribute(&major, attribute_major, number);
  functions.attribute(&minor, attribute_minor, number);
  functions.attribute(&gpu.num_multiprocessors, attribute_multiprocessors, number);
  functions.memory(&num_bytes, number);
  gpu.name = name;
  gpu.architecture = 10 * major + minor;
  gpu.num_bytes = static_cast<std::int64_t>(num_bytes);
  return gpu;
}

struct OpenDriver {
  Functions functions{};
  GpuDriver driver;
};

OpenDriver open_and_ask() {
  OpenDriver open;
  GpuDriver& driver = open.driver;
  driver.is_installed =
      std::filesystem::exists("/proc/driver/nvidia/version") || std::filesystem::exists("/dev/nvidia0");
  void* library = open_driver();
  if (library == nullptr) {
    driver.failure = "libcuda.so.1 was not found";
    return open;
  }
  driver.is_installed = true;
  driver.has_plain_name = dlopen("libcuda.so", RTLD_LAZY | RTLD_LOCAL) != nullptr;
  if (!load_functions(library, open.functions)) {
    driver.failure = "libcuda.so.1 lacks functions of a CUDA driver";
    return open;
  }
  driver.library = path_of(reinterpret_cast<void*>(open.functions.initialize));
  const int error = open.functions.initialize(0);
  if (error != success) {
    const char* text = nullptr;
    open.functions.error_text(error, &text);
    driver.failure = std::string("it does not start: ") + (text != nullptr ? text : "error " + std::to_string(error));
    return open;
  }
  int count = 0;
  open.functions.count(&count);
  for (int number = 0; number < count; ++number) driver.gpus.push_back(describe(open.functions, number));
  return open;
}

const OpenDriver& opened() {
  static const OpenDriver open = open_and_ask();
  return open;
}

std::string architecture_name(int architecture) {
  return std::to_string(architecture / 10) + "." + std::to_string(architecture % 10);
}

/// An image runs on the architecture it was made for and on later ones of the same generation.
bool runs_on(int image_architecture, int architecture) {
  return image_architecture / 10 == architecture / 10 && image_architecture <= architecture;
}

std::string why_unused(const GpuDriver& driver, const Gpu& gpu, int image_architecture) {
  const std::string own = std::to_string(gpu.architecture);
  if (image_architecture == 0)
    return "this program has no nvptx image. Install a CUDA toolkit (ptxas) and build again from an empty folder with "
           "-DTENTPOLE_GPU_ARCH=sm_" +
           own + ".";
  if (!runs_on(image_architecture, gpu.architecture))
    return "its compute capability is " + architecture_name(gpu.architecture) + ", but this program's image is for " +
           architecture_name(image_architecture) + ". Build again from an empty folder with -DTENTPOLE_GPU_ARCH=sm_" +
           own + ".";
  if (!driver.has_plain_name)
    return "LLVM's offload runtime opens libcuda.so, and the driver brings only " + driver.library +
           ". Make the name: mkdir -p ~/cuda && ln -s " + driver.library +
           " ~/cuda/libcuda.so && export LD_LIBRARY_PATH=~/cuda:$LD_LIBRARY_PATH";
  return "LLVM's offload runtime does not list it. LIBOMPTARGET_DEBUG=1 (a runtime built with it) or "
         "LIBOMPTARGET_INFO=-1 may tell why. Common causes: the GPU is in exclusive mode or used by another process; "
         "the "
         "runtime is older than LLVM 22 and cannot read the image, as CUDA 13 links it (docs/gpu.md, The layout of the "
         "image).";
}

}  // namespace

const GpuDriver& gpu_driver() {
  return opened().driver;
}

std::optional<std::int64_t> free_gpu_memory(int gpu) {
  const OpenDriver& open = opened();
  if (gpu < 0 || gpu >= static_cast<int>(open.driver.gpus.size())) return std::nullopt;
  Context context = nullptr;
  if (open.functions.retain_context(&context, gpu) != success) return std::nullopt;
  std::size_t free = 0, total = 0;
  bool is_known = false;
  if (open.functions.push_context(context) == success) {
    is_known = open.functions.free_memory(&free, &total) == success;
    open.functions.pop_context(&context);
  }
  open.functions.release_context(gpu);
  if (!is_known) return std::nullopt;
  return static_cast<std::int64_t>(free);
}

std::vector<std::string> unused_gpus(const GpuDriver& driver, int image_architecture, int num_used) {
  if (!driver.is_installed) return {};
  if (!driver.failure.empty())
    return {"a GPU's driver is installed, but " + driver.failure +
            ". `nvidia-smi` must work first; in a container, the driver's libraries must be mounted."};
  std::vector<std::string> reasons;
  for (std::size_t number = num_used; number < driver.gpus.size(); ++number) {
    const Gpu& gpu = driver.gpus[number];
    reasons.push_back("GPU " + std::to_string(number) + " (" + gpu.name +
                      ") is not used: " + why_unused(driver, gpu, image_architecture));
  }
  return reasons;
}

}  // namespace tentpole
