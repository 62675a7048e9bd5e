#include "host/command_line/csv_table.hpp"

#include <charconv>
#include <fstream>
#include <sstream>

#include "host/case_file/input_error.hpp"

namespace tentpole {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> entries;
  std::istringstream stream(line);
  for (std::string entry; std::getline(stream, entry, ',');) entries.push_back(entry);
  return entries;
}

/// The numbers of a line; fewer than there are entries if one of them is no number.
std::vector<double> numbers(const std::string& line) {
  std::vector<double> values;
  for (const std::string& entry : split(line)) {
    double value = 0;
    const auto [end, error] = std::from_chars(entry.data(), entry.data() + entry.size(), value);
    if (error != std::errc() || end != entry.data() + entry.size()) break;
    values.push_back(value);
  }
  return values;
}

}  // namespace

CsvTable read_csv_table(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line)) throw InputError(file.string() + ": cannot be read or is empty.");
  CsvTable table;
  table.columns = split(line);
  for (int number = 2; std::getline(stream, line); ++number) {
    table.rows.push_back(numbers(line));
    if (table.rows.back().size() != table.columns.size())
      throw InputError(file.string() + ":" + std::to_string(number) + ": needs " +
                       std::to_string(table.columns.size()) + " numbers, one per column, but reads \"" + line + "\".");
  }
  return table;
}

}  // namespace tentpole
