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
  std::string git_revision;  ///< at configuration time; "unknown" outside a repository
  std::string compiler;
  std::string type;          ///< CMake build type
  std::string architecture;  ///< value of -march
};
BuildInfo build_info();

}  // namespace tentpole
