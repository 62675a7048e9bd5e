#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "host/output/fields.hpp"
#include "host/output/output_folder.hpp"
#include "host/output/slice_cells.hpp"
#include "host/output/spacetime_element.hpp"
#include "host/output/time_coverage.hpp"
#include "host/output/vtkhdf_writer.hpp"
#include "host/output/written_files.hpp"

namespace tentpole {

/// One element's part of a snapshot, ready to be written.
struct SnapshotPiece {
  std::array<double, 4> place{};  ///< centroid of the element, the order in the file
  std::int64_t id = 0;
  std::int64_t region = 0;
  SliceCells cells;
  std::vector<double> values;       ///< [num_points][components of the fields of points]
  std::vector<double> cell_values;  ///< [components of the fields of cells]
};

/// The files snapshot_NNNN.vtkhdf and snapshot.vtkhdf.series of a run.
class SnapshotSeries {
 public:
  struct Options {
    int num_subdivisions = 1;  ///< per edge of a slice
    bool plane_stress = false;
    OutputFolder folder;
    std::vector<double> times;        ///< [s], strictly ascending
    std::vector<std::string> fields;  ///< names of fields.hpp
  };

  /// Throws std::invalid_argument for an unknown or repeated field and for times out of order.
  explicit SnapshotSeries(Options options);

  OutputRange range(double time_min, double time_max) const {
    return covered_times(options_.times, time_min, time_max);
  }

  /// Keeps the element's slice at all times it covers.
  void record(const SpacetimeElement& element, const ElementFields& fields);

  /// Writes and forgets the snapshots that the front has passed.
  void finish(double front_minimum_time);

  void save(std::ostream& stream) const;
  void load(std::istream& stream);

  /// The files written so far.
  void add_written(WrittenFiles& files) const;

 private:
  void write_snapshot(int index);
  void write_series_file() const;

  Options options_;
  std::vector<const OutputField*> fields_;
  std::vector<std::vector<SnapshotPiece>> pieces_;  ///< [times]
  int num_written_ = 0;
};

}  // namespace tentpole
