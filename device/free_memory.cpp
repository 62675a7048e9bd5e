#include "device/free_memory.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include <sys/resource.h>
#include <unistd.h>

namespace tentpole {
namespace {

std::optional<std::int64_t> available_to_all() {
  std::ifstream lines("/proc/meminfo");
  std::string name;
  std::int64_t kibibytes = 0;
  while (lines >> name >> kibibytes) {
    if (name == "MemAvailable:") return 1024 * kibibytes;
    lines.ignore(80, '\n');
  }
  return std::nullopt;
}

std::int64_t left_of_limit() {
  constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max();
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  std::int64_t pages = 0;
  if (!(std::ifstream("/proc/self/statm") >> pages)) return unlimited;
  return std::max<std::int64_t>(0, static_cast<std::int64_t>(limit.rlim_cur) - pages * sysconf(_SC_PAGESIZE));
}

}  // namespace

std::optional<std::int64_t> free_host_memory() {
  const std::optional<std::int64_t> available = available_to_all();
  if (!available) return std::nullopt;
  return std::min(*available, left_of_limit());
}

}  // namespace tentpole
