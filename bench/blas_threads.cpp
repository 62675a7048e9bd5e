#include "bench/blas_threads.hpp"

#include <dlfcn.h>

namespace tentpole {

bool set_blas_threads(int num_threads) {
  using SetNumThreads = void (*)(int);
  const auto set = reinterpret_cast<SetNumThreads>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
  if (set) set(num_threads);
  return set != nullptr;
}

}  // namespace tentpole
