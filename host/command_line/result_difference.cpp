#include "host/command_line/result_difference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

#include "host/command_line/csv_table.hpp"
#include "host/command_line/snapshot_reader.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;

/// Extremes of one quantity over all files.
struct Extremes {
  double difference = 0;
  double magnitude = 0;
  std::string file;  ///< of the largest difference
};

class Comparison {
 public:
  void add(const std::string& quantity, const std::string& file, double a, double b) {
    ++result_.num_values;
    if (a == b) ++result_.num_equal;
    Extremes& extremes = extremes_[quantity];
    extremes.magnitude = std::max(extremes.magnitude, std::abs(a));
    const double difference = std::abs(a - b);
    // Written so that NaN counts as infinitely different.
    if (difference <= extremes.difference) return;
    extremes.difference = std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
    extremes.file = file;
  }

  ResultDifference result() {
    for (const auto& [quantity, extremes] : extremes_) {
      if (extremes.difference == 0) continue;
      const double relative = extremes.difference / extremes.magnitude;
      if (relative <= result_.largest) continue;
      result_.largest = relative;
      result_.where = quantity + " in " + extremes.file;
    }
    return result_;
  }

 private:
  ResultDifference result_;
  std::map<std::string, Extremes> extremes_;
};

[[noreturn]] void report_mismatch(const fs::path& file) {
  throw std::runtime_error(file.string() +
                           ": the two results have different files or numbers of values, so their fronts differ");
}

void compare_snapshots(const fs::path& first, const fs::path& second, Comparison& comparison) {
  const SnapshotFile a = read_snapshot(first), b = read_snapshot(second);
  if (a.fields.size() != b.fields.size()) report_mismatch(first);
  for (std::size_t field = 0; field < a.fields.size(); ++field) {
    const SnapshotField &from = a.fields[field], &to = b.fields[field];
    if (from.name != to.name || from.values.size() != to.values.size()) report_mismatch(first);
    for (std::size_t i = 0; i < from.values.size(); ++i)
      comparison.add(from.name, first.filename().string(), from.values[i], to.values[i]);
  }
}

void compare_tables(const fs::path& first, const fs::path& second, Comparison& comparison) {
  const CsvTable a = read_csv_table(first), b = read_csv_table(second);
  if (a.columns != b.columns || a.rows.size() != b.rows.size()) report_mismatch(first);
  const std::string name = first.filename().string();
  for (std::size_t row = 0; row < a.rows.size(); ++row)
    for (std::size_t column = 0; column < a.columns.size(); ++column)
      comparison.add(name + " " + a.columns[column], name, a.rows[row][column], b.rows[row][column]);
}

/// Files whose names begin and end like this, in ascending order.
std::vector<fs::path> files(const fs::path& folder, const std::string& start, const std::string& end) {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(start) && name.ends_with(end)) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

ResultDifference compare_results(const fs::path& first, const fs::path& second) {
  std::vector<fs::path> snapshots = files(first, "snapshot_", ".vtkhdf");
  const std::vector<fs::path> cracks = files(first, "cracks_", ".vtkhdf");
  snapshots.insert(snapshots.end(), cracks.begin(), cracks.end());
  std::vector<fs::path> tables = files(first, "probe_", ".csv");
  if (snapshots.empty() && tables.empty()) tables = {first / "history.csv"};
  Comparison comparison;
  for (const std::vector<fs::path>& kind : {snapshots, tables})
    for (const fs::path& file : kind)
      if (!fs::exists(second / file.filename())) report_mismatch(file);
  for (const fs::path& file : snapshots) compare_snapshots(file, second / file.filename(), comparison);
  for (const fs::path& file : tables) compare_tables(file, second / file.filename(), comparison);
  return comparison.result();
}

}  // namespace tentpole
