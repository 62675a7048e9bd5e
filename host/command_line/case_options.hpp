#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "device/device.hpp"
#include "device/thread_choice.hpp"
#include "host/problem/simulation.hpp"

namespace tentpole {

/// What the commands that take a case file have in common.
struct CaseOptions {
  std::filesystem::path case_file;
  std::vector<std::string> overrides;  ///< "section.key=value"
  std::optional<std::uint64_t> seed;   ///< replaces domain.seed and fracture.nucleation.seed
  int threads = 0;                     ///< 0: as many as the machine grants
};

/// How many threads a run gets, and why not those asked for.
ThreadChoice choose_threads(const CaseOptions& options);

/// Reads the case with its overrides and makes its mesh; prints the warnings on stderr. From then on the thread pools
/// of the program are limited: OpenMP's to choose_threads(options), BLAS to one, because its calls come from parallel
/// loops. Throws InputError or MeshError.
Simulation read_simulation(const CaseOptions& options);

/// The host, or with `offload` or a number the device that select_device chooses; a warning on stderr where `offload`
/// leaves a GPU of this machine unused. Throws InputError, with the way out, if there is no such device.
Device choose_device(bool offload, std::optional<int> number);

}  // namespace tentpole
