#pragma once

#include <string>
#include <vector>

namespace tentpole {

/// Rows of a table as lines of text, columns two blanks apart and as wide as their longest entry, each line indented by
/// two blanks. `alignment` has one letter per column, 'l' or 'r'; rows may be shorter than that. UTF-8 letters count as
/// one place; control characters of entries appear as escapes (host/mesh/printable.hpp).
std::string text_table(const std::vector<std::vector<std::string>>& rows, const std::string& alignment);

}  // namespace tentpole
