#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>

#include <sys/types.h>

namespace tentpole {

/// Which file or folder it is, whatever its name.
struct FileIdentity {
  dev_t device = 0;
  ino_t inode = 0;

  bool operator==(const FileIdentity&) const = default;
};

/// Of what the path names now, or the descriptor; none if there is nothing.
std::optional<FileIdentity> identity_of(const std::filesystem::path& path);
std::optional<FileIdentity> identity_of(int descriptor);

/// The result folder is not the one any more that the run began in, or belongs to another run: nothing may be written
/// there, no checkpoint either.
class FolderLost : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace tentpole
