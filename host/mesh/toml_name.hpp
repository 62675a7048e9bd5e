#pragma once

#include <string>

namespace tentpole {

/// A name as a string of TOML: in quotation marks, with escapes for quotation marks, backslashes and control
/// characters.
std::string toml_string(const std::string& name);

/// A name as a key of TOML: as it is where it has only ASCII letters, digits, "_" and "-"; else as a string.
std::string toml_key(const std::string& name);

}  // namespace tentpole
