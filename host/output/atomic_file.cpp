#include "host/output/atomic_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

namespace tentpole {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const char* action) {
  const int error = errno;
  throw std::runtime_error(file.string() + ": cannot " + action + ": " + std::strerror(error) +
                           ". Check the free space and the permissions of the folder.");
}

/// Waits until the file is on the disk.
void flush_to_disk(const std::filesystem::path& path, int folder) {
  const Descriptor file(openat(folder, path.filename().c_str(), O_RDONLY | O_CLOEXEC));
  if (file < 0) fail(path, "open");
  if (fsync(file) != 0) fail(path, "flush");
}

/// Some file systems cannot flush a folder; the rename is still atomic there.
void flush_folder(int folder) {
  const Descriptor readable(openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (readable >= 0) fsync(readable);
}

}  // namespace

std::string partial_name(const std::string& name) {
  return "." + name + ".partial";
}

void replace_file(const OutputFolder& folder, const std::string& name,
                  const std::function<void(const std::filesystem::path&)>& write) {
  // What the path names can change at any time; the folder that is open here stays.
  const Descriptor directory = folder.open();
  const std::filesystem::path partial = folder / partial_name(name);
  try {
    write(partial);
    flush_to_disk(partial, directory);
  } catch (const std::runtime_error&) {
    folder.open();  // that it is lost says more than that writing failed
    throw;
  }
  folder.open();
  if (renameat(directory, partial.filename().c_str(), directory, name.c_str()) != 0)
    fail(folder / name, "rename the finished file");
  flush_folder(directory);
}

void replace_text_file(const OutputFolder& folder, const std::string& name, std::string_view text) {
  replace_file(folder, name, [&](const std::filesystem::path& partial) {
    std::ofstream stream(partial, std::ios::binary | std::ios::trunc);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) fail(partial, "write");
  });
}

}  // namespace tentpole
