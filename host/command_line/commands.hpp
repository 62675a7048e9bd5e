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
  bool offload = false;
  std::optional<int> device;
  bool check = false;
  bool quiet = false;
};
int run_command(const RunCommand& command);

int check_command(const CaseOptions& input);

struct CompareCommand {
  CaseOptions input;
  std::optional<std::filesystem::path> out;  ///< keeps both results in OUT/host and OUT/device
  std::optional<int> device;
  bool quiet = false;
};
int compare_command(const CompareCommand& command);

int devices_command();

int info_command(const std::filesystem::path& path);

/// Replaces this process by scripts/plot.py; returns only by an exception.
int plot_command(const std::vector<std::string>& arguments);

}  // namespace tentpole
