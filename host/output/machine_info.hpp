#pragma once

#include <cstdint>
#include <string>

namespace tentpole {

/// The machine the program runs on.
struct MachineInfo {
  std::string processor;                 ///< model name as the system reports it; empty if unknown
  int cores = 0;                         ///< hardware threads that this process may use
  std::int64_t peak_resident_bytes = 0;  ///< largest resident memory of this process so far
};
MachineInfo machine_info();

/// How the program was built.
struct BuildInfo {
  std::string version;
  std::string git_revision;   ///< "unknown" outside a repository
  std::string source_digest;  ///< of the sources that decide what the program computes
  std::string compiler;
  std::string type;          ///< CMake build type
  std::string architecture;  ///< value of -march
  std::string instructions;  ///< what of it decides how sums round: "512-bit vectors, fused multiply-add"
};
BuildInfo build_info();

/// All that decides the bits of a result beside the case, on one line: two programs with the same text go the same way.
std::string build_identity();

}  // namespace tentpole
