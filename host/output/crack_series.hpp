#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <span>
#include <vector>

#include "common/simplex.hpp"
#include "host/output/written_files.hpp"

namespace tentpole {

/// Contact of a fracture edge: that of most of its points in its last patch.
enum class CrackMode : std::int64_t { open = 0, stick = 1, slip = 2 };

/// A fracture edge of the front (D = 2) or a fracture vertex (D = 1).
struct CrackSegment {
  std::array<std::array<double, 3>, 2> end{};  ///< [m], lower vertex id first; D = 1: both the vertex
  std::int64_t id = 0;                         ///< number of the edge, never given to another one
  CrackMode mode = CrackMode::open;
  int num_points = 0;                            ///< values below: at the Gauss points from end[0] to end[1]; D = 1: 1
  std::array<double, max_degree + 1> damage{};   ///< in [0, 1]
  std::array<double, max_degree + 1> opening{};  ///< [m], normal gap, positive where the faces have parted
};

/// The files cracks_NNNN.vtkhdf and cracks.vtkhdf.series of a run, numbered as the snapshots: the fracture edges of the
/// front when its lowest vertex had just passed the time, so up to a tent's height later than the time. Not thread
/// safe.
class CrackSeries {
 public:
  struct Options {
    int dimension = 0;  ///< 1 or 2
    std::filesystem::path folder;
    std::vector<double> times;  ///< [s], strictly ascending: those of the snapshots
  };

  /// Throws std::invalid_argument for another dimension and for times out of order. Nothing is written before the first
  /// finish(), which replaces older files of the same names.
  explicit CrackSeries(Options options);

  /// Whether finish() has a file to write; otherwise the segments need not be collected.
  bool wants(double front_minimum_time) const;

  /// Writes `segments`, in any order, to every file whose time the lowest vertex [s] has passed; at the end call it
  /// with the end time. A file without segments is written too, so the series is as long as that of the snapshots.
  /// Throws std::invalid_argument for a segment without points or with too many, std::runtime_error if a file cannot be
  /// written.
  void finish(double front_minimum_time, std::span<const CrackSegment> segments);

  /// For checkpoints: how many files are written.
  void save(std::ostream& stream) const;
  void load(std::istream& stream);

  /// The files written so far.
  void add_written(WrittenFiles& files) const;

 private:
  Options options_;
  int num_written_ = 0;
};

}  // namespace tentpole
