#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

namespace tentpole {

/// A table that grows by whole lines: a header line, then rows. The file is created by the first append, so a resumed
/// run can call `load` before anything is overwritten.
class CsvFile {
 public:
  CsvFile(std::filesystem::path file, std::string header);

  /// Appends complete lines in one write; other processes see all of them or none. Throws std::runtime_error if the
  /// file cannot be written.
  void append(std::string_view lines);

  /// The length of the file goes into a checkpoint; `load` cuts the file back to it and throws std::runtime_error if
  /// the file is shorter than that.
  void save(std::ostream& stream) const;
  void load(std::istream& stream);

 private:
  std::filesystem::path file_;
  std::string header_;
  std::int64_t num_bytes_ = 0;
};

/// Adds the shortest decimal number that reads back as `value`.
void append_number(std::string& line, double value);

}  // namespace tentpole
