#include "host/command_line/text_table.hpp"

#include <algorithm>

#include "host/mesh/printable.hpp"

namespace tentpole {
namespace {

/// Places that UTF-8 text takes: every byte but the continuation bytes 10xxxxxx starts a letter.
std::size_t num_places(const std::string& text) {
  return std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; });
}

}  // namespace

std::string text_table(const std::vector<std::vector<std::string>>& rows, const std::string& alignment) {
  std::vector<std::size_t> width(alignment.size(), 0);
  std::vector<std::vector<std::string>> shown = rows;
  for (auto& row : shown)
    for (std::size_t column = 0; column < row.size(); ++column) {
      row[column] = printable(row[column]);
      width[column] = std::max(width[column], num_places(row[column]));
    }
  std::string text;
  for (const auto& row : shown) {
    std::string line;
    for (std::size_t column = 0; column < row.size(); ++column) {
      const std::string padding(width[column] - num_places(row[column]), ' ');
      line += "  " + (alignment[column] == 'r' ? padding + row[column] : row[column] + padding);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace tentpole
