#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "common/simplex.hpp"
#include "host/output/crack_strip.hpp"
#include "host/output/output_folder.hpp"
#include "host/output/time_coverage.hpp"
#include "host/output/written_files.hpp"

namespace tentpole {

/// A part of a fracture edge (D = 2) or a fracture vertex (D = 1) at one time.
struct CrackSegment {
  std::array<std::array<double, 3>, 2> end{};  ///< [m], towards the lower vertex id first; D = 1: both the vertex
  std::int64_t id = 0;                         ///< number of the edge, never given to another one
  double begin = 0;                            ///< fraction of the edge where the part begins
  CrackMode mode = CrackMode::open;
  int num_points = 0;                            ///< values below: at the Gauss points from end[0] to end[1]; D = 1: 1
  std::array<double, max_degree + 1> damage{};   ///< in [0, 1]
  std::array<double, max_degree + 1> opening{};  ///< [m], normal gap, positive where the faces have parted
};

/// The files cracks_NNNN.vtkhdf and cracks.vtkhdf.series of a run, numbered as the snapshots: the fracture edges at
/// these times, each cut where it belongs to another patch. Segments may arrive in any order. Not thread safe.
class CrackSeries {
 public:
  struct Options {
    int dimension = 0;  ///< 1 or 2
    OutputFolder folder;
    std::vector<double> times;  ///< [s], strictly ascending: those of the snapshots
  };

  /// Throws std::invalid_argument for another dimension and for times out of order. Nothing is written before the first
  /// finish(), which replaces older files of the same names.
  explicit CrackSeries(Options options);

  const std::vector<double>& times() const { return options_.times; }

  /// The files to which a strip with this time range [s] belongs.
  OutputRange range(double time_min, double time_max) const { return covered_times(times(), time_min, time_max); }

  /// Adds a segment to the file `index`. Throws std::logic_error if that is written already, std::invalid_argument for
  /// a segment without points or with too many.
  void add(int index, const CrackSegment& segment);

  /// Writes every file whose time the lowest vertex [s] has passed; at the end call it with the end time. A file
  /// without segments is written too, so the series is as long as that of the snapshots. Throws std::runtime_error if a
  /// file cannot be written.
  void finish(double front_minimum_time);

  /// For checkpoints: how many files are written, and the segments of the others.
  void save(std::ostream& stream) const;
  void load(std::istream& stream);

  /// The files written so far.
  void add_written(WrittenFiles& files) const;

 private:
  Options options_;
  std::vector<std::vector<CrackSegment>> segments_;  ///< [file], of those not written
  int num_written_ = 0;
};

}  // namespace tentpole
