#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "host/output/output_folder.hpp"

namespace tentpole {

/// Writes a file so that its final name never shows an incomplete one: `write` fills a hidden file beside it
/// (.NAME.partial), which is flushed to the disk and then renamed. Throws std::runtime_error with the path and the
/// reason, FolderLost if the folder was deleted, moved or replaced since it was claimed.
void replace_file(const OutputFolder& folder, const std::string& name,
                  const std::function<void(const std::filesystem::path&)>& write);

/// The same for text.
void replace_text_file(const OutputFolder& folder, const std::string& name, std::string_view text);

/// Where replace_file() prepares a file.
std::string partial_name(const std::string& name);

}  // namespace tentpole
