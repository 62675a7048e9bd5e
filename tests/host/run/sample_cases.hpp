#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace tentpole {

/// Small cases with waves, loads, probes and every kind of output, for D = 1, 2, 3; a second or less each.
std::string sample_case(int dimension);

/// The whole file.
std::string bytes_of(const std::filesystem::path& file);

/// Result files by name with all their bytes, and summary.json without what depends on the clock, the machine and the
/// cutting into batches.
std::vector<std::pair<std::string, std::string>> results_in(const std::filesystem::path& folder);

}  // namespace tentpole
