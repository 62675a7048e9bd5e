#pragma once

#include <filesystem>
#include <optional>

namespace tentpole {

/// What prepare_result_folder did.
struct PreparedFolder {
  std::filesystem::path path;
  std::optional<std::filesystem::path> moved_aside;  ///< where an older result of that name is now
};

/// "result_STEM" in the current folder for a case file STEM.toml.
std::filesystem::path default_result_folder(const std::filesystem::path& case_file);

/// Whether the folder holds files of a run, complete or not.
bool holds_result(const std::filesystem::path& folder);

/// Creates the folder, with its parents. An older result there is moved aside to the first free name of NAME.1, NAME.2,
/// ...; nothing is ever overwritten. Throws InputError if the path is a file, or a folder with other files in it, or
/// cannot be created.
PreparedFolder prepare_result_folder(const std::filesystem::path& folder);

}  // namespace tentpole
