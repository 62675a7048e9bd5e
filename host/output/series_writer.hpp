#pragma once

#include <span>
#include <string>

#include "host/output/output_folder.hpp"

namespace tentpole {

/// One file of a time series; `name` is relative to the folder of the series file.
struct SeriesEntry {
  std::string name;
  double time;  ///< [s]
};

/// Writes ParaView's file-series JSON, atomically; `name` should be NAME.vtkhdf.series.
void write_series(const OutputFolder& folder, const std::string& name, std::span<const SeriesEntry> entries);

}  // namespace tentpole
