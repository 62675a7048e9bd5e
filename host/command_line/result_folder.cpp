#include "host/command_line/result_folder.hpp"

#include <string>

#include <unistd.h>

#include "host/case_file/input_error.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;

/// Files of a run, and those that it did not finish (.NAME.partial, host/output/atomic_file.hpp).
bool is_result_file(const fs::path& file) {
  std::string name = file.filename().string();
  if (name.starts_with('.') && name.ends_with(".partial")) name.erase(0, 1);
  for (const char* start : {"summary.json", "history.csv", "checkpoint.h5", "snapshot", "cracks", "probe_"})
    if (name.starts_with(start)) return true;
  return false;
}

/// A path without a slash at its end, so that ".1" can be appended.
fs::path without_slash(const fs::path& folder) {
  return folder.has_filename() ? folder : folder.parent_path();
}

fs::path first_free_name(const fs::path& folder) {
  for (int number = 1;; ++number) {
    const fs::path candidate = folder.string() + "." + std::to_string(number);
    if (!fs::exists(fs::symlink_status(candidate))) return candidate;
  }
}

/// Refuses where a run works in it.
fs::path move_aside(const fs::path& folder) {
  std::optional<FolderLock> lock;
  if (access(folder.c_str(), W_OK) == 0) lock.emplace(folder);  // no run works where nobody may write
  const fs::path free_name = first_free_name(folder);
  fs::rename(folder, free_name);
  return free_name;
}

bool holds_other_files(const fs::path& folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().filename() != FolderLock::file_name) return true;
  return false;
}

}  // namespace

fs::path default_result_folder(const fs::path& case_file) {
  return "result_" + case_file.stem().string();
}

bool holds_result(const fs::path& folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (is_result_file(entry.path())) return true;
  return false;
}

PreparedFolder prepare_result_folder(const fs::path& given) {
  const fs::path path = without_slash(given);
  const std::string name = path.string();
  std::optional<fs::path> moved_aside;
  try {
    if (fs::exists(path)) {
      if (!fs::is_directory(path))
        throw InputError(name + ": is a file, so no result folder can have this name. Give another one with --out.");
      if (holds_result(path)) {
        moved_aside = move_aside(path);
      } else if (holds_other_files(path)) {
        throw InputError(
            name +
            ": this folder holds files that are no result of tentpole, and results do not mix with others. "
            "Give a new or empty folder with --out.");
      }
    }
    fs::create_directories(path);
    return {path, FolderLock(path), moved_aside};
  } catch (const fs::filesystem_error& error) {
    throw InputError(name + ": cannot be made a result folder (" + error.code().message() +
                     "). Give another one with --out.");
  }
}

PreparedFolder reopen_result_folder(const fs::path& folder) {
  try {
    return {folder, FolderLock(folder), std::nullopt};
  } catch (const fs::filesystem_error& error) {
    throw InputError(folder.string() + ": a run cannot go on in this folder (" + error.code().message() +
                     "). Copy it to where you may write, and resume there.");
  }
}

}  // namespace tentpole
