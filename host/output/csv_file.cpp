#include "host/output/csv_file.hpp"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "host/output/binary_stream.hpp"

namespace tentpole {

CsvFile::CsvFile(OutputFolder folder, std::string name, std::string header)
    : folder_(std::move(folder)), name_(std::move(name)), header_(std::move(header)) {}

void CsvFile::append(std::string_view lines) {
  std::string text = num_bytes_ == 0 ? header_ + "\n" : std::string();
  text += lines;
  const Descriptor descriptor = open_own();
  const auto written = descriptor < 0 ? ssize_t{-1} : write(descriptor, text.data(), text.size());
  const int error = errno;
  const bool complete = written == std::ssize(text);
  // A full disk can take the beginning of a line; the file keeps whole lines only.
  const bool cut = complete || written <= 0 || ftruncate(descriptor, num_bytes_) == 0;
  if (!complete)
    throw std::runtime_error((folder_ / name_).string() +
                             ": cannot append rows: " + (written < 0 ? std::strerror(error) : "the disk is full") +
                             (cut ? "" : ", and its last line is incomplete") +
                             ". Check the free space and the permissions of the folder.");
  num_bytes_ += written;
}

/// Through its folder, so that the file opened lies in the folder that was looked at.
Descriptor CsvFile::open_own() {
  const Descriptor folder = folder_.open();
  const bool creates = num_bytes_ == 0 && !identity_;
  Descriptor file(
      openat(folder, name_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | (creates ? O_CREAT | O_TRUNC : 0), 0666));
  if (file < 0 && errno == ENOENT) lose("it was deleted");
  if (file >= 0) check_own(file);
  return file;
}

void CsvFile::check_own(int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) lose(std::strerror(errno));
  const bool begins = !identity_;
  if (begins) identity_ = FileIdentity{status.st_dev, status.st_ino};
  if (identity_ != FileIdentity{status.st_dev, status.st_ino}) lose("another file has taken its place");
  // A resumed run takes back the rows that came after its checkpoint.
  const bool cut = begins && status.st_size > num_bytes_ && ftruncate(descriptor, num_bytes_) == 0;
  if (status.st_size != num_bytes_ && !cut)
    lose("the run wrote " + std::to_string(num_bytes_) + " bytes and it has " + std::to_string(status.st_size));
}

void CsvFile::lose(const std::string& what) const {
  throw FolderLost((folder_ / name_).string() + ": the table is not this run's any more: " + what +
                   ". Nothing was written there. Let each run have a folder of its own, and start this one anew or go "
                   "on from a checkpoint.");
}

void CsvFile::save(std::ostream& stream) const {
  write_value(stream, num_bytes_);
}

void CsvFile::load(std::istream& stream) {
  num_bytes_ = read_number(stream, std::numeric_limits<std::int64_t>::max(), "the length of a table");
}

void CsvFile::add_written(WrittenFiles& files) const {
  if (num_bytes_ > 0) files.push_back({folder_ / name_, num_bytes_});
}

void append_number(std::string& line, double value) {
  char text[32];
  const auto result = std::to_chars(text, text + sizeof text, value);
  line.append(text, result.ptr);
}

}  // namespace tentpole
