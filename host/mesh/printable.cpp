#include "host/mesh/printable.hpp"

#include <cstdio>

#include "common/utf8.hpp"

namespace tentpole {

namespace {

/// Control characters, and format characters that move what stands beside them.
bool is_harmful(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x61c || (code >= 0x200e && code <= 0x200f) ||
         (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) || code == 0xfeff;
}

std::string escaped(std::uint32_t code) {
  if (code == '\n') return "\\n";
  if (code == '\t') return "\\t";
  if (code == '\r') return "\\r";
  char text[16];
  std::snprintf(text, sizeof text, code < 0x80 ? "\\x%02x" : "\\u%04x", static_cast<unsigned>(code));
  return text;
}

std::string without_harm(std::string_view text, bool keeps_lines) {
  std::string result;
  while (!text.empty()) {
    const std::size_t size = utf8_character_size(text);
    if (size == 0) {
      char byte[8];
      std::snprintf(byte, sizeof byte, "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(text[0])));
      result += byte;
      text.remove_prefix(1);
      continue;
    }
    const std::uint32_t code = utf8_code_point(text, size);
    if (is_harmful(code) && !(keeps_lines && code == '\n'))
      result += escaped(code);
    else
      result += text.substr(0, size);
    text.remove_prefix(size);
  }
  return result;
}

}  // namespace

std::string printable(std::string_view text) {
  return without_harm(text, false);
}

std::string printable_lines(std::string_view text) {
  return without_harm(text, true);
}

}  // namespace tentpole
