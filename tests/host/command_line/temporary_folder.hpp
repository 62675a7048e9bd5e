#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace tentpole {

/// An empty folder that disappears with its owner.
class TemporaryTestFolder {
 public:
  explicit TemporaryTestFolder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / ("tentpole_" + name + "_" + std::to_string(getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryTestFolder() { std::filesystem::remove_all(path_); }
  TemporaryTestFolder(const TemporaryTestFolder&) = delete;
  TemporaryTestFolder& operator=(const TemporaryTestFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Writes a file, with the folders it lies in.
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace tentpole
