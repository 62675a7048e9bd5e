#include "host/output/output_folder.hpp"

#include <utility>

#include <fcntl.h>

namespace tentpole {

OutputFolder::OutputFolder(std::filesystem::path path)
    : path_(path.empty() ? "." : std::move(path)), claimed_(std::make_shared<std::optional<FileIdentity>>()) {}

void OutputFolder::claim() const {
  *claimed_ = identity_of(path_);
}

Descriptor OutputFolder::open() const {
  Descriptor folder(::open(path_.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  const std::optional<FileIdentity> now = identity_of(folder);
  if (!*claimed_) *claimed_ = now;
  require_same_folder(path_, now, *claimed_);
  return folder;
}

void require_same_folder(const std::filesystem::path& path, const std::optional<FileIdentity>& now,
                         const std::optional<FileIdentity>& claimed) {
  if (!now)
    throw FolderLost(path.string() +
                     ": the result folder was deleted or moved while the run was at work. Nothing was written "
                     "since. Start the run anew, or go on from a checkpoint where the folder is now.");
  if (now != claimed)
    throw FolderLost(path.string() +
                     ": another folder has taken the place of the run's result folder. Nothing was written "
                     "there. Start the run anew with another --out, or go on from a checkpoint where its folder "
                     "is now.");
}

}  // namespace tentpole
