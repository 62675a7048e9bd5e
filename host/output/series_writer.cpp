#include "host/output/series_writer.hpp"

#include <nlohmann/json.hpp>

#include "host/output/atomic_file.hpp"

namespace tentpole {

void write_series(const OutputFolder& folder, const std::string& name, std::span<const SeriesEntry> entries) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const SeriesEntry& entry : entries) files.push_back({{"name", entry.name}, {"time", entry.time}});
  const nlohmann::ordered_json series = {{"file-series-version", "1.0"}, {"files", files}};
  replace_text_file(folder, name, series.dump(1) + "\n");
}

}  // namespace tentpole
