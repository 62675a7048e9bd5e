// The functions of a CUDA driver that device/gpu_driver.cpp asks, for a GPU that is not there:
// FAKE_GPU_ARCHITECTURE (90 by default) is its compute capability times ten.
#include <cstdlib>
#include <cstring>

namespace {

int architecture() {
  const char* text = std::getenv("FAKE_GPU_ARCHITECTURE");
  return text != nullptr ? std::atoi(text) : 90;
}

}  // namespace

extern "C" {

int cuInit(unsigned) {
  return 0;
}
int cuGetErrorString(int, const char** text) {
  *text = "fake";
  return 0;
}
int cuDeviceGetCount(int* count) {
  *count = 1;
  return 0;
}
int cuDeviceGetName(char* name, int length, int) {
  std::strncpy(name, "Fake GPU", length);
  return 0;
}
int cuDeviceGetAttribute(int* value, int attribute, int) {
  *value = attribute == 75 ? architecture() / 10 : (attribute == 76 ? architecture() % 10 : 132);
  return 0;
}
int cuDeviceTotalMem_v2(std::size_t* num_bytes, int) {
  *num_bytes = 80'000'000'000;
  return 0;
}
int cuDevicePrimaryCtxRetain(void** context, int) {
  *context = nullptr;
  return 0;
}
int cuDevicePrimaryCtxRelease_v2(int) {
  return 0;
}
int cuCtxPushCurrent_v2(void*) {
  return 0;
}
int cuCtxPopCurrent_v2(void**) {
  return 0;
}
int cuMemGetInfo_v2(std::size_t* free_bytes, std::size_t* num_bytes) {
  *free_bytes = 79'000'000'000;
  *num_bytes = 80'000'000'000;
  return 0;
}

}  // extern "C"
