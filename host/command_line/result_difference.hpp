#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace tentpole {

/// How far two results of one case are apart.
struct ResultDifference {
  double largest = 0;           ///< relative, see below
  std::string where;            ///< file and quantity of the largest one
  std::int64_t num_values = 0;  ///< numbers compared
  std::int64_t num_equal = 0;   ///< of them, the same bit for bit
};

/// Compares all point data of all snapshots and all probe tables of two result folders; where the case has neither, the
/// history. A difference is relative to the largest absolute value that the quantity has in the whole first result:
/// max |a - b| / max |a|. Throws std::runtime_error if the results do not have the same files and sizes.
ResultDifference compare_results(const std::filesystem::path& first, const std::filesystem::path& second);

}  // namespace tentpole
