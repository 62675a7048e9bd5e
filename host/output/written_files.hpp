#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tentpole {

/// A file of the result folder that a checkpoint counts on.
struct WrittenFile {
  std::filesystem::path file;
  std::int64_t num_bytes = 1;  ///< it has at least so many
};
using WrittenFiles = std::vector<WrittenFile>;

/// Throws std::runtime_error, naming those that are missing or too short and the way out.
void require_written(const WrittenFiles& files);

}  // namespace tentpole
