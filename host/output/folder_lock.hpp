#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "host/output/descriptor.hpp"
#include "host/output/lock_record.hpp"

namespace tentpole {

/// Makes a folder the property of this process as long as the object exists, by a lock on the file .lock in it. The
/// system gives the lock up when the process ends, however it ends, and on file systems with locks it holds for all
/// machines that share the folder. On file systems without locks the file alone counts: whether the process that it
/// names still lives can then be told on its own machine only.
class FolderLock {
 public:
  /// Throws InputError, naming the owner and the way out, if another process has the folder or may have it;
  /// std::filesystem::filesystem_error if the lock file cannot be made.
  explicit FolderLock(std::filesystem::path folder);
  /// Removes the lock file.
  ~FolderLock();
  FolderLock(FolderLock&&) noexcept = default;
  FolderLock& operator=(FolderLock&&) = delete;

  /// Call before each write. Throws FolderLost if the path names another folder or none by now, or if the folder has
  /// another owner (possible without locks, or where somebody deleted the lock file).
  void require() const;

  /// Name of the lock file.
  static constexpr const char* file_name = ".lock";

 private:
  bool take();
  bool take_existing();
  bool take_unlocked();
  void give_up();
  void write_record();
  bool is_own_file() const;
  std::filesystem::path file() const { return folder_ / file_name; }

  std::filesystem::path folder_;
  Descriptor directory_;
  Descriptor file_;  ///< the lock lives as long as it is open
};

}  // namespace tentpole
