// A driver of an NVIDIA GPU, as far as LLVM's offload runtime asks before it hands over an image: one GPU of the
// architecture TENTPOLE_GPU_ARCHITECTURE, 90 for 9.0. When it gets the image, it says in which layout it is and ends
// the program.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" {

int cuDeviceGetCount(int* count) {
  *count = 1;
  return 0;
}

int cuDeviceGet(int* device, int number) {
  *device = number;
  return 0;
}

int cuDriverGetVersion(int* version) {
  *version = 13000;
  return 0;
}

int cuDeviceGetName(char* name, int length, int) {
  std::snprintf(name, length, "pretended GPU");
  return 0;
}

int cuDeviceTotalMem_v2(std::size_t* num_bytes, int) {
  *num_bytes = std::size_t{1} << 36;
  return 0;
}

int cuDevicePrimaryCtxRetain(void** context, int device) {
  static int contexts[1];
  *context = &contexts[device];
  return 0;
}

/// Warps of 32 lanes, 132 multiprocessors, the two parts of the architecture; all other attributes are sizes.
int cuDeviceGetAttribute(int* value, int attribute, int) {
  switch (attribute) {
    case 10:
      *value = 32;
      break;
    case 16:
      *value = 132;
      break;
    case 75:
      *value = TENTPOLE_GPU_ARCHITECTURE / 10;
      break;
    case 76:
      *value = TENTPOLE_GPU_ARCHITECTURE % 10;
      break;
    default:
      *value = 1024;
  }
  return 0;
}

int cuModuleLoadDataEx(void**, const unsigned char* image, unsigned, int*, void**) {
  const auto flags = reinterpret_cast<const std::uint32_t*>(image)[12];
  std::printf("image taken: ABI version %d, flags %#x\n", image[8], flags);
  std::fflush(stdout);
  std::_Exit(0);
}

#define TENTPOLE_SUCCEED(name) \
  int name() {                 \
    return 0;                  \
  }
TENTPOLE_SUCCEED(cuInit)
TENTPOLE_SUCCEED(cuGetErrorString)
TENTPOLE_SUCCEED(cuCtxEnablePeerAccess)
TENTPOLE_SUCCEED(cuCtxGetDevice)
TENTPOLE_SUCCEED(cuCtxGetLimit)
TENTPOLE_SUCCEED(cuCtxSetCurrent)
TENTPOLE_SUCCEED(cuCtxSetLimit)
TENTPOLE_SUCCEED(cuDeviceCanAccessPeer)
TENTPOLE_SUCCEED(cuDevicePrimaryCtxGetState)
TENTPOLE_SUCCEED(cuDevicePrimaryCtxRelease_v2)
TENTPOLE_SUCCEED(cuDevicePrimaryCtxSetFlags_v2)
TENTPOLE_SUCCEED(cuEventCreate)
TENTPOLE_SUCCEED(cuEventDestroy)
TENTPOLE_SUCCEED(cuEventRecord)
TENTPOLE_SUCCEED(cuEventSynchronize)
TENTPOLE_SUCCEED(cuFuncGetAttribute)
TENTPOLE_SUCCEED(cuLaunchKernel)
TENTPOLE_SUCCEED(cuMemAllocAsync)
TENTPOLE_SUCCEED(cuMemAllocHost_v2)
TENTPOLE_SUCCEED(cuMemAllocManaged)
TENTPOLE_SUCCEED(cuMemAlloc_v2)
TENTPOLE_SUCCEED(cuMemFreeAsync)
TENTPOLE_SUCCEED(cuMemFreeHost)
TENTPOLE_SUCCEED(cuMemFree_v2)
TENTPOLE_SUCCEED(cuMemHostRegister_v2)
TENTPOLE_SUCCEED(cuMemHostUnregister)
TENTPOLE_SUCCEED(cuMemHostGetDevicePointer_v2)
TENTPOLE_SUCCEED(cuMemHostGetFlags)
TENTPOLE_SUCCEED(cuMemcpyDtoDAsync_v2)
TENTPOLE_SUCCEED(cuMemcpyDtoHAsync_v2)
TENTPOLE_SUCCEED(cuMemcpyDtoH_v2)
TENTPOLE_SUCCEED(cuMemcpyHtoDAsync_v2)
TENTPOLE_SUCCEED(cuMemcpyHtoD_v2)
TENTPOLE_SUCCEED(cuMemcpyPeerAsync)
TENTPOLE_SUCCEED(cuMemGetInfo_v2)
TENTPOLE_SUCCEED(cuModuleGetFunction)
TENTPOLE_SUCCEED(cuModuleGetGlobal_v2)
TENTPOLE_SUCCEED(cuModuleUnload)
TENTPOLE_SUCCEED(cuStreamCreate)
TENTPOLE_SUCCEED(cuStreamDestroy_v2)
TENTPOLE_SUCCEED(cuStreamQuery)
TENTPOLE_SUCCEED(cuStreamSynchronize)
TENTPOLE_SUCCEED(cuStreamWaitEvent)
}
