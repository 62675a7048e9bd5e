#include "host/output/written_files.hpp"

#include <stdexcept>
#include <string>

namespace tentpole {
namespace {

/// What is wrong with it; empty if nothing is.
std::string fault(const WrittenFile& written) {
  std::error_code error;
  const auto size = std::filesystem::file_size(written.file, error);
  if (error) return written.file.string() + " is missing";
  if (static_cast<std::int64_t>(size) >= written.num_bytes) return "";
  return written.file.string() + " has " + std::to_string(size) + " bytes of " + std::to_string(written.num_bytes);
}

}  // namespace

void require_written(const WrittenFiles& files) {
  constexpr int most_named = 5;
  std::string faults;
  int num_faults = 0;
  for (const WrittenFile& written : files) {
    const std::string text = fault(written);
    if (text.empty()) continue;
    if (num_faults < most_named) faults += (num_faults > 0 ? ", " : "") + text;
    ++num_faults;
  }
  if (num_faults == 0) return;
  if (num_faults > most_named) faults += ", and " + std::to_string(num_faults - most_named) + " more";
  throw std::runtime_error("output that it goes on from is not there: " + faults +
                           ". Resume in the result folder that the checkpoint belongs to, with all its files, or start "
                           "anew.");
}

}  // namespace tentpole
