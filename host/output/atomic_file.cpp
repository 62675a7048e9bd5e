#include "host/output/atomic_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include "host/output/descriptor.hpp"
#include "host/output/file_identity.hpp"

namespace tentpole {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const char* action) {
  const int error = errno;
  throw std::runtime_error(file.string() + ": cannot " + action + ": " + std::strerror(error) +
                           ". Check the free space and the permissions of the folder.");
}

/// Waits until the file is on the disk.
void flush_to_disk(const std::filesystem::path& path) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file < 0) fail(path, "open");
  if (fsync(file) != 0) fail(path, "flush");
}

/// Some file systems cannot flush a folder; the rename is still atomic there.
void flush_folder(int folder) {
  const Descriptor readable(openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (readable >= 0) fsync(readable);
}

/// `descriptor`: of the folder when the file was begun.
void require_same_folder(const std::filesystem::path& file, const std::filesystem::path& folder, int descriptor) {
  const std::optional<FileIdentity> now = identity_of(folder);
  if (!now || (descriptor >= 0 && now != identity_of(descriptor)))
    throw FolderLost(file.string() +
                     ": its folder was deleted, moved or replaced while the file was being written. It was given up.");
}

}  // namespace

void replace_file(const std::filesystem::path& file, const std::function<void(const std::filesystem::path&)>& write) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const std::filesystem::path partial = folder / ("." + file.filename().string() + ".partial");
  // What the path names can change while the file is being written.
  const Descriptor directory(open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  try {
    write(partial);
    flush_to_disk(partial);
  } catch (const std::runtime_error&) {
    require_same_folder(file, folder, directory);
    throw;
  }
  require_same_folder(file, folder, directory);
  if (renameat(directory, partial.filename().c_str(), directory, file.filename().c_str()) != 0)
    fail(file, "rename the finished file");
  flush_folder(directory);
}

void replace_text_file(const std::filesystem::path& file, std::string_view text) {
  replace_file(file, [&](const std::filesystem::path& partial) {
    std::ofstream stream(partial, std::ios::binary | std::ios::trunc);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) fail(partial, "write");
  });
}

}  // namespace tentpole
