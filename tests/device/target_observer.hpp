#pragma once

#include <cstdint>

namespace tentpole {

/// What the OpenMP runtime itself reports about target devices through its tools interface (OMPT), since the program
/// started: the independent witness for TrafficCounters. Only in builds with device images.
struct ObservedTraffic {
  std::int64_t bytes_to_device;
  std::int64_t bytes_from_device;
  std::int64_t launches;
};
ObservedTraffic observed_traffic();

/// Whether the runtime accepted both callbacks; if not, observed_traffic() stays zero and proves nothing. libomptarget
/// looks for the tool with dlopen("libomp.so") on the default search path, where Debian does not have that name: tests
/// that observe need LD_LIBRARY_PATH to name the folder of libomp.so (CTest sets it).
bool is_observing();

}  // namespace tentpole
