#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "host/output/descriptor.hpp"
#include "host/output/file_identity.hpp"

namespace tentpole {

/// A folder that a run writes into. Files are written through open(), never by a path that may name another folder by
/// then. Copies stand for the same folder.
class OutputFolder {
 public:
  /// Any path names a folder. An empty path is the current folder.
  OutputFolder(std::filesystem::path path = {});

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  /// What the path names now is the folder from now on, also for all copies. Without it the first open() claims.
  void claim() const;

  /// For openat and its relatives. Throws FolderLost if the path names another folder than the one claimed, or none.
  Descriptor open() const;

 private:
  std::filesystem::path path_;
  std::shared_ptr<std::optional<FileIdentity>> claimed_;
};

/// Throws FolderLost if `now`, what the path of a result folder names, is not the folder `claimed`.
void require_same_folder(const std::filesystem::path& path, const std::optional<FileIdentity>& now,
                         const std::optional<FileIdentity>& claimed);

}  // namespace tentpole
