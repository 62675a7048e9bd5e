#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>

#include <nlohmann/json.hpp>

#include "host/command_line/commands.hpp"
#include "host/command_line/csv_table.hpp"
#include "host/command_line/quantity.hpp"
#include "host/command_line/result_folder.hpp"
#include "host/command_line/run_report.hpp"
#include "host/command_line/snapshot_reader.hpp"
#include "host/command_line/text_table.hpp"
#include "host/mesh/printable.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;

std::string value_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return count_text(value.get<std::int64_t>());
  if (value.is_number()) return short_number(value.get<double>());
  if (value.is_array()) return count_text(std::ssize(value)) + " in summary.json";
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Deeper parts of a summary are left out: no run writes them, and they would take as deep a stack.
constexpr int deepest = 16;

/// The top level first, then each section under its name.
void describe_summary(const fs::path& file) {
  std::ifstream stream(file);
  const Json summary = Json::parse(
      stream, [](int depth, Json::parse_event_t, const Json&) { return depth <= deepest; }, false);
  if (!summary.is_object()) throw InputError(file.string() + ": is not JSON, so it is no summary of a run.");
  Rows top;
  for (const auto& [name, value] : summary.items())
    if (!value.is_structured()) top.push_back({name, value_text(value)});
  std::cout << text_table(top, "ll");
  for (const auto& [name, section] : summary.items()) {
    if (!section.is_structured() || section.empty()) continue;
    Rows rows;
    for (const auto& [key, value] : section.items())
      rows.push_back(section.is_array() ? std::vector{value_text(value)} : std::vector{key, value_text(value)});
    std::cout << printable(name) << "\n" << text_table(rows, "ll");
  }
}

void describe_snapshot(const fs::path& file) {
  const SnapshotFile snapshot = read_snapshot(file);
  std::cout << (file.filename().string().starts_with("cracks") ? "cracks" : "snapshot")
            << " at t = " << short_number(snapshot.time) << " s, " << count_text(snapshot.num_cells) << " cells, "
            << count_text(snapshot.num_points) << " points\n";
  Rows rows{{"field", "components", "smallest", "largest"}};
  for (const SnapshotField& field : snapshot.fields) {
    const auto [smallest, largest] = std::minmax_element(field.values.begin(), field.values.end());
    const bool is_empty = field.values.empty();
    rows.push_back({field.name, std::to_string(field.num_components), is_empty ? "-" : short_number(*smallest),
                    is_empty ? "-" : short_number(*largest)});
  }
  std::cout << text_table(rows, "lrrr");
}

void describe_table(const fs::path& file) {
  const CsvTable table = read_csv_table(file);
  std::cout << count_text(std::ssize(table.rows)) << " rows\n";
  if (table.rows.empty()) return;
  Rows rows{{"column", "first", "last", "smallest", "largest"}};
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    std::vector<double> values;
    for (const auto& row : table.rows) values.push_back(row[column]);
    const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
    rows.push_back({table.columns[column], short_number(values.front()), short_number(values.back()),
                    short_number(*smallest), short_number(*largest)});
  }
  std::cout << text_table(rows, "lrrrr");
}

void describe_folder(const fs::path& folder) {
  if (!holds_result(folder)) throw InputError(folder.string() + ": this folder holds no result of tentpole.");
  if (fs::exists(folder / "summary.json"))
    describe_summary(folder / "summary.json");
  else if (fs::exists(folder / "checkpoint.h5"))
    std::cout << "the run is not complete; go on with: tentpole run CASE --resume "
              << printable((folder / "checkpoint.h5").string()) << "\n";
  else
    std::cout << "the run is not complete, and there is no checkpoint\n";
  std::cout << files_text(folder);
}

}  // namespace

int info_command(const fs::path& path) {
  const std::string extension = path.extension().string();
  if (!fs::exists(path)) throw InputError(path.string() + ": there is no such file or folder.");
  if (fs::is_directory(path)) {
    describe_folder(path);
  } else if (extension == ".json") {
    describe_summary(path);
  } else if (extension == ".vtkhdf") {
    describe_snapshot(path);
  } else if (extension == ".h5") {
    const Rows contents = list_hdf5_contents(path);
    std::cout << "data sets of the checkpoint\n" << text_table(contents, "lr");
  } else if (extension == ".csv") {
    describe_table(path);
  } else {
    throw InputError(path.string() + ": is neither a result folder nor a .json, .vtkhdf, .csv or .h5 file of one." +
                     (extension == ".toml" ? " `tentpole check` describes case files." : ""));
  }
  return 0;
}

}  // namespace tentpole
