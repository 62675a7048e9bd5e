#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/command_line/case_options.hpp"

namespace tentpole {

/// One function per command of the program. Each returns the exit code (0 done, 130 interrupted with a checkpoint) and
/// prints on stdout; notes and warnings go to stderr. Errors are exceptions: InputError and MeshError for what the user
/// can correct (exit code 2), others for a run that failed (exit code 1).

struct RunCommand {
  CaseOptions input;
  std::optional<std::filesystem::path> out;     ///< result folder
  std::optional<std::filesystem::path> resume;  ///< checkpoint
  bool force = false;                           ///< also one of another build
  bool offload = false;
  std::optional<int> device;
  bool check = false;
  bool quiet = false;
};
int run_command(const RunCommand& command);

/// Everything that `run` with the same options does before its first patch.
struct CheckCommand {
  CaseOptions input;
  bool offload = false;
  std::optional<int> device;
};
int check_command(const CheckCommand& command);

struct CompareCommand {
  CaseOptions input;
  std::optional<std::filesystem::path> out;  ///< keeps both results in OUT/host and OUT/device
  std::optional<int> device;
  bool quiet = false;
};
int compare_command(const CompareCommand& command);

/// A modelled sweep of threads (host/many_core) as CSV.
struct ModelCommand {
  std::filesystem::path machine_file;  ///< a path, or the name of a file in device/machines
  int rows = 990;                      ///< size of the cell matrix; 990: degree 7 in three dimensions
  std::optional<std::string> threads;  ///< list; default: 1 to twice the cores
};
int model_command(const ModelCommand& command);

/// `calibrate`: instead of the list, measure this machine for the model and write its file; empty: machine.toml.
int devices_command(const std::optional<std::filesystem::path>& calibrate);

int info_command(const std::filesystem::path& path);

/// Replaces this process by scripts/plot.py; returns only by an exception.
int plot_command(const std::vector<std::string>& arguments);

}  // namespace tentpole
