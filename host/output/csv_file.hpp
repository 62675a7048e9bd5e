#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "host/output/descriptor.hpp"
#include "host/output/file_identity.hpp"
#include "host/output/output_folder.hpp"
#include "host/output/written_files.hpp"

namespace tentpole {

/// A table that grows by whole lines: a header line, then rows. The file is created by the first append, or cut back to
/// what was loaded, so a resumed run touches nothing before. From then on it is this run's alone.
class CsvFile {
 public:
  CsvFile(OutputFolder folder, std::string name, std::string header);

  /// Appends complete lines in one write; other processes see all of them or none. Throws std::runtime_error if the
  /// file cannot be written, FolderLost if its folder or itself was deleted, replaced or written by others meanwhile;
  /// what is there now stays as it is.
  void append(std::string_view lines);

  /// The length of the file goes into a checkpoint.
  void save(std::ostream& stream) const;
  void load(std::istream& stream);

  /// The file, if it has rows; at least as long as the rows written.
  void add_written(WrittenFiles& files) const;

 private:
  Descriptor open_own();
  void check_own(int descriptor);
  [[noreturn]] void lose(const std::string& what) const;

  OutputFolder folder_;
  std::string name_;
  std::string header_;
  std::int64_t num_bytes_ = 0;
  std::optional<FileIdentity> identity_;  ///< of the file, from the first append on
};

/// Adds the shortest decimal number that reads back as `value`.
void append_number(std::string& line, double value);

}  // namespace tentpole
