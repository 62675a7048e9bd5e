#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <vector>

#include "host/fracture/crack_edge_state.hpp"
#include "host/output/output_folder.hpp"
#include "host/output/time_coverage.hpp"
#include "host/output/written_files.hpp"

namespace tentpole {

/// Work done and energy lost in one element or patch between two times [J, per unit of the missing dimensions].
struct EnergyFlow {
  double external_work = 0;
  double numerical = 0;  ///< numerical dissipation, >= 0
  double fracture = 0;
  double friction = 0;
};

/// State of the front that is noted in a row when the front has passed its time.
struct FrontState {
  std::int64_t fragments = 0;
  std::int64_t cells = 0;
  double smallest_cell = 0;  ///< [m], shortest edge
};

/// What happens to cracks, each with a column of its own.
enum class CrackEvent { nucleation, extension, branch, coalescence };

/// history.csv: one row per output time, columns time [s], kinetic, strain, external_work, numerical, fracture,
/// friction [J], crack_length [m], damage_mean, damage_max, nucleations, extensions, branches, coalescences, fragments,
/// cells, smallest_cell [m]. Energies are exact sums (common/exact_sum.hpp), so the order of the calls does not matter.
/// external_work, numerical, fracture, friction and the counts of events are cumulative from t = 0. crack_length is
/// that of surfaces with damage >= 0.999, damage_mean is over all fracture surfaces. Not thread safe.
class History {
 public:
  /// Rows at 0, interval, 2 interval, .., end [s] (`end` always the last); nothing is written before the
  /// first finish(), which replaces an older file.
  /// Throws std::invalid_argument unless 0 < interval and 0 < end, std::runtime_error if the file cannot be written.
  History(const OutputFolder& folder, double interval, double end);
  ~History();
  History(History&&) noexcept;
  History& operator=(History&&) noexcept;

  /// Memory that every row takes from the beginning to the end of a run.
  static std::size_t bytes_per_row();

  const std::vector<double>& times() const;

  /// The rows that an element with this time range covers.
  OutputRange rows(double time_min, double time_max) const;

  /// Adds one element's energies on the slice of `row` (kernels/launch/slice_energies.hpp).
  void add_energy(int row, double kinetic, double strain);

  /// Spreads `flow` linearly over [time_min, time_max]: a row in between gets the share of the time range before it.
  /// Elements are shorter than the row interval, so a row is off by at most what its cut elements exchange; rows on a
  /// flat front (the end) are exact.
  void add_interval(double time_min, double time_max, const EnergyFlow& flow);

  /// Adds a part of a fracture surface, of this measure [m^(D-1)], at the time of `row`.
  void add_surface(int row, double measure, const CrackEdgeState& part);

  /// Counts an event at `time` [s]; one that comes after its row was written counts from the next.
  void add_event(CrackEvent event, double time);

  /// Appends and flushes the rows that the front has passed, whole lines only, each with `state`.
  void finish(double front_minimum_time, const FrontState& state);

  /// For checkpoints; the next rows come after the saved ones.
  void save(std::ostream& stream) const;
  void load(std::istream& stream);
  void add_written(WrittenFiles& files) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tentpole
