#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace tentpole {

/// Writes a file so that its final name never shows an incomplete one: `write` fills a hidden file beside it
/// (.NAME.partial), which is flushed to the disk and then renamed. Throws std::runtime_error with the path and the
/// reason, FolderLost if the folder was deleted, moved or replaced meanwhile.
void replace_file(const std::filesystem::path& file, const std::function<void(const std::filesystem::path&)>& write);

/// The same for text.
void replace_text_file(const std::filesystem::path& file, std::string_view text);

}  // namespace tentpole
