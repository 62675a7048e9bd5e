#include "host/output/machine_info.hpp"

#include <fstream>

#include <gnu/libc-version.h>
#include <sched.h>
#include <source_revision.hpp>
#include <sys/resource.h>

namespace tentpole {
namespace {

std::string processor_name() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("model name")) {
      const auto start = line.find_first_not_of(": \t", line.find(':'));
      return start == std::string::npos ? "" : line.substr(start);
    }
  return "";
}

int usable_cores() {
  cpu_set_t set;
  return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

std::int64_t peak_resident_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;  // Linux reports KiB
}

std::string instructions() {
#if defined(__AVX512F__)
  std::string text = "512-bit vectors";
#elif defined(__AVX__)
  std::string text = "256-bit vectors";
#else
  std::string text = "128-bit vectors";
#endif
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
  text += ", fused multiply-add";
#endif
  return text;
}

}  // namespace

MachineInfo machine_info() {
  return {processor_name(), usable_cores(), peak_resident_bytes()};
}

BuildInfo build_info() {
#if defined(__clang__)
  const std::string compiler = __VERSION__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
  return {TENTPOLE_VERSION,    TENTPOLE_GIT_REVISION, TENTPOLE_SOURCE_DIGEST, compiler,
          TENTPOLE_BUILD_TYPE, TENTPOLE_ARCHITECTURE, instructions()};
}

std::string build_identity() {
  const BuildInfo build = build_info();
  return "tentpole " + build.version + ", sources " + build.source_digest + ", " + build.compiler + ", " + build.type +
         ", " + build.architecture + " with " + build.instructions + ", C library " + gnu_get_libc_version();
}

}  // namespace tentpole
