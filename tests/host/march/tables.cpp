#include "tests/host/march/tables.hpp"

#include <algorithm>
#include <cmath>

namespace tentpole::testing {

Table table_of(const SolvedRun& run, const std::string& file) {
  return read_table(run.files.at(file));
}

double largest_difference(const Table& expected, const Table& found) {
  double difference = expected.size() == found.size() ? 0 : INFINITY;
  for (const auto& [name, column] : expected) {
    const auto other = found.find(name);
    if (other == found.end() || other->second.size() != column.size()) return INFINITY;
    double scale = 0;
    for (const double value : column) scale = std::max(scale, std::fabs(value));
    for (std::size_t row = 0; row < column.size(); ++row)
      difference = std::max(difference, std::fabs(other->second[row] - column[row]) / (scale > 0 ? scale : 1));
  }
  return difference;
}

}  // namespace tentpole::testing
