#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "device/device.hpp"
#include "host/output/run_summary.hpp"
#include "host/problem/simulation.hpp"

namespace tentpole {

/// How far a run is.
struct Progress {
  double front_time = 0;  ///< [s]
  double end_time = 0;    ///< [s]
  std::int64_t patches = 0;
  int cells = 0;
};

struct RunOptions {
  Device device = host_device();
  int threads = 0;               ///< 0: all of the device's
  std::filesystem::path folder;  ///< result folder
  /// Called once, when the run has passed all tests and before anything is read from the folder or written to it;
  /// `folder` must exist then. Unless given: creates it.
  std::function<void()> prepare_folder;
  bool check = false;                           ///< energy balance of every patch
  std::optional<std::filesystem::path> resume;  ///< checkpoint to go on from
  bool any_build = false;                       ///< also from one that another build of the program wrote
  std::function<void(const Progress&)> report = [](const Progress&) {};
  std::function<bool()> interrupted = [] { return false; };
  /// Called before anything is written to the folder; throws FolderLost if the folder is not the run's any more.
  std::function<void()> require_folder = [] {};
  std::function<void(const std::string&)> note = [](const std::string&) {};  ///< what the user should know at once
};

struct RunResult {
  RunSummary summary;
  bool interrupted = false;          ///< a checkpoint was written instead of a summary file
  std::filesystem::path checkpoint;  ///< folder / "checkpoint.h5" if interrupted, else empty
};

/// Does what run_simulation does before its first patch, with all its tests, writes nothing and forgets it: whatever
/// this throws, run_simulation throws as well, and before it has written anything. Takes the memory of a run at its
/// start.
void prepare_run(const Simulation& simulation, const RunOptions& options);

/// Solves a simulation and writes its result folder: snapshots, probes, history, and summary.json at the end. When
/// interrupted, at the case's checkpoint interval, and when a patch cannot be solved, checkpoint.h5 is written there,
/// from which `resume` goes on bitwise identically (also with another batch size, device or number of threads, as far
/// as the device computes alike); a run that reaches the end removes it. `folder` must then hold the output of the run
/// that wrote the checkpoint. Throws std::runtime_error with place and time when a patch cannot be solved, InputError
/// where an expression is not finite; the message says which checkpoint there is, and all finished output stays
/// readable. Throws InputError for a checkpoint that is damaged, of a run with other settings, (unless any_build) of
/// another build of the program, or whose output is gone; FolderLost, writing nothing any more, when the folder is
/// deleted, replaced or taken by another run.
RunResult run_simulation(const Simulation& simulation, const RunOptions& options);

}  // namespace tentpole
