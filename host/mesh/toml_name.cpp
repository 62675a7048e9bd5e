#include "host/mesh/toml_name.hpp"

#include <algorithm>
#include <cstdio>

namespace tentpole {

namespace {

bool is_bare(char character) {
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
         (character >= '0' && character <= '9') || character == '_' || character == '-';
}

bool is_control(char character) {
  return (character >= 0 && character < ' ') || character == 0x7f;
}

}  // namespace

std::string toml_string(const std::string& name) {
  std::string text = "\"";
  for (const char character : name) {
    if (is_control(character)) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04X", static_cast<unsigned>(character));
      text += escape;
    } else {
      if (character == '"' || character == '\\') text += '\\';
      text += character;
    }
  }
  return text + "\"";
}

std::string toml_key(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), is_bare) ? name : toml_string(name);
}

}  // namespace tentpole
