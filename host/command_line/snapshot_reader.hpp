#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tentpole {

/// One field of a snapshot: `num_components` values per point, component fastest.
struct SnapshotField {
  std::string name;
  int num_components = 1;
  std::vector<double> values;
};

/// A snapshot file read back.
struct SnapshotFile {
  double time = 0;  ///< [s]
  std::int64_t num_points = 0;
  std::int64_t num_cells = 0;
  std::vector<SnapshotField> fields;  ///< point data, ascending name
};

/// Reads a snapshot_*.vtkhdf of this program. Throws InputError naming the file if it is none.
SnapshotFile read_snapshot(const std::filesystem::path& file);

/// Names of all data sets of an HDF5 file with their extents, "group/name" and "100 x 3", ascending. Throws InputError
/// if it is no HDF5 file.
std::vector<std::vector<std::string>> list_hdf5_contents(const std::filesystem::path& file);

}  // namespace tentpole
