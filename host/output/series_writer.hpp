#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace tentpole {

/// One file of a time series; `name` is relative to the folder of the series file.
struct SeriesEntry {
  std::string name;
  double time;  ///< [s]
};

/// Writes ParaView's file-series JSON, atomically; `file` should be named NAME.vtkhdf.series.
void write_series(const std::filesystem::path& file, std::span<const SeriesEntry> entries);

}  // namespace tentpole
