#include "host/output/atomic_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace tentpole {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const char* action) {
  const int error = errno;
  throw std::runtime_error(file.string() + ": cannot " + action + ": " + std::strerror(error) +
                           ". Check the free space and the permissions of the folder.");
}

/// Waits until the file or folder is on the disk.
void flush_to_disk(const std::filesystem::path& path, int flags) {
  const int descriptor = open(path.c_str(), flags);
  if (descriptor < 0) fail(path, "open");
  const int result = fsync(descriptor);
  close(descriptor);
  // Some file systems cannot flush a folder; the rename is still atomic there.
  if (result != 0 && !(flags & O_DIRECTORY)) fail(path, "flush");
}

}  // namespace

void replace_file(const std::filesystem::path& file, const std::function<void(const std::filesystem::path&)>& write) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const std::filesystem::path partial = folder / ("." + file.filename().string() + ".partial");
  write(partial);
  flush_to_disk(partial, O_RDONLY);
  if (rename(partial.c_str(), file.c_str()) != 0) fail(file, "rename the finished file");
  flush_to_disk(folder, O_RDONLY | O_DIRECTORY);
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
