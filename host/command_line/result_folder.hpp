#pragma once

#include <filesystem>
#include <optional>

#include "host/output/folder_lock.hpp"

namespace tentpole {

/// A result folder that belongs to this process as long as the object exists.
struct PreparedFolder {
  std::filesystem::path path;
  FolderLock lock;
  std::optional<std::filesystem::path> moved_aside;  ///< where an older result of that name is now
};

/// "result_STEM" in the current folder for a case file STEM.toml.
std::filesystem::path default_result_folder(const std::filesystem::path& case_file);

/// Whether the folder holds files of a run, complete or not.
bool holds_result(const std::filesystem::path& folder);

/// Creates the folder, with its parents. An older result there is moved aside to the first free name of NAME.1, NAME.2,
/// ...; nothing is ever overwritten. Throws InputError if the path is a file, or a folder with other files in it, or
/// one in which another run works, or cannot be created.
PreparedFolder prepare_result_folder(const std::filesystem::path& folder);

/// The folder of a checkpoint, for a run that goes on there. Throws InputError if another run works in it.
PreparedFolder reopen_result_folder(const std::filesystem::path& folder);

}  // namespace tentpole
