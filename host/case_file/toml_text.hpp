#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tentpole {

/// What a case file may have at most; the largest sensible case is far below.
inline constexpr std::size_t largest_toml_file = 16'000'000;  ///< [B]
inline constexpr int deepest_toml_nesting = 20;               ///< of brackets, and parts of a dotted key

/// The first place of a text that is not to be given to the parser of TOML, which recurses with the depth and takes for
/// granted that names are ASCII.
struct TomlTextFault {
  int line;    ///< from 1
  int column;  ///< from 1, in characters
  std::string reason;
};

/// Looks through a text for brackets and dotted keys that are too deep, bytes that are no UTF-8, and letters beyond
/// ASCII and control characters outside of quotation marks and comments. Nothing else about the text need be right.
std::optional<TomlTextFault> find_toml_text_fault(std::string_view text);

}  // namespace tentpole
