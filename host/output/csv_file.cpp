#include "host/output/csv_file.hpp"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "host/output/binary_stream.hpp"

namespace tentpole {

CsvFile::CsvFile(std::filesystem::path file, std::string header) : file_(std::move(file)), header_(std::move(header)) {}

void CsvFile::append(std::string_view lines) {
  const bool first = num_bytes_ == 0;
  std::string text = first ? header_ + "\n" : std::string();
  text += lines;
  const int descriptor = open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | (first ? O_TRUNC : 0), 0666);
  const auto written = descriptor < 0 ? ssize_t{-1} : write(descriptor, text.data(), text.size());
  const int error = errno;
  const bool complete = written == static_cast<ssize_t>(text.size());
  // A full disk can take the beginning of a line; the file keeps whole lines only.
  const bool cut = complete || written <= 0 || ftruncate(descriptor, num_bytes_) == 0;
  if (descriptor >= 0) close(descriptor);
  if (!complete)
    throw std::runtime_error(
        file_.string() + ": cannot append rows: " + (written < 0 ? std::strerror(error) : "the disk is full") +
        (cut ? "" : ", and its last line is incomplete") + ". Check the free space and the permissions of the folder.");
  num_bytes_ += static_cast<std::int64_t>(text.size());
}

void CsvFile::save(std::ostream& stream) const {
  write_value(stream, num_bytes_);
}

void CsvFile::load(std::istream& stream) {
  num_bytes_ = read_number(stream, std::numeric_limits<std::int64_t>::max(), "the length of a table");
  if (num_bytes_ == 0) return;
  std::error_code error;
  const auto size = std::filesystem::file_size(file_, error);
  if (error || static_cast<std::int64_t>(size) < num_bytes_)
    throw std::runtime_error(file_.string() + ": the checkpoint expects " + std::to_string(num_bytes_) +
                             " bytes and the file " + (error ? "is missing" : "has " + std::to_string(size)) +
                             ". Resume in the result folder that the checkpoint belongs to.");
  std::filesystem::resize_file(file_, static_cast<std::uintmax_t>(num_bytes_));
}

void append_number(std::string& line, double value) {
  char text[32];
  const auto result = std::to_chars(text, text + sizeof text, value);
  line.append(text, result.ptr);
}

}  // namespace tentpole
