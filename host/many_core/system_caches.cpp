#include "host/many_core/system_caches.hpp"

#include <algorithm>
#include <fstream>
#include <string>

#include <unistd.h>

namespace tentpole {

double private_cache_bytes() {
  constexpr double usual = 288.0 * 1024;
  const long l1 = sysconf(_SC_LEVEL1_DCACHE_SIZE), l2 = sysconf(_SC_LEVEL2_CACHE_SIZE);
  return l1 > 0 && l2 > 0 ? static_cast<double>(l1 + l2) : usual;
}

int threads_per_core() {
  // "0,4" or "0-1": the hardware threads of the core that has number 0.
  std::ifstream stream("/sys/devices/system/cpu/cpu0/topology/thread_siblings_list");
  std::string text;
  if (!(stream >> text)) return 1;
  const auto dash = text.find('-');
  if (dash != std::string::npos && text.find(',') == std::string::npos)
    return std::clamp(std::stoi(text.substr(dash + 1)) - std::stoi(text) + 1, 1, 64);
  return 1 + static_cast<int>(std::count(text.begin(), text.end(), ','));
}

int page_bytes() {
  return static_cast<int>(std::max(1L, sysconf(_SC_PAGESIZE)));
}

}  // namespace tentpole
