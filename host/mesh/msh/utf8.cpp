#include "host/mesh/msh/utf8.hpp"

#include <cstdint>

#include "common/utf8.hpp"

namespace tentpole {

namespace {

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = utf8_character_size(text);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

}  // namespace

std::string as_utf8(std::string_view text) {
  if (is_utf8(text)) return std::string(text);
  std::string result;
  for (const char character : text) {
    const auto code = static_cast<std::uint8_t>(character);
    if (code < 0x80) {
      result += character;
    } else {
      result += static_cast<char>(0xc0 | (code >> 6));
      result += static_cast<char>(0x80 | (code & 0x3f));
    }
  }
  return result;
}

}  // namespace tentpole
