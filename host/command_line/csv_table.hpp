#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tentpole {

/// A table of numbers as history.csv and probe_*.csv hold it.
struct CsvTable {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

/// Throws InputError with file, line and text if a row has other than one number per column, or the file cannot be
/// read.
CsvTable read_csv_table(const std::filesystem::path& file);

}  // namespace tentpole
