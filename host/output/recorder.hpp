#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "host/output/output_folder.hpp"
#include "host/output/probe.hpp"
#include "host/output/spacetime_element.hpp"

namespace tentpole {

struct RecorderOptions {
  int dimension = 0;
  int degree = 0;
  bool plane_stress = false;           ///< D = 2: the out-of-plane stress is 0 instead of lambda tr E
  OutputFolder folder;                 ///< must exist when the first file is written
  std::vector<double> snapshot_times;  ///< [s], ascending
  std::vector<std::string> fields;     ///< names of fields.hpp
  std::vector<ProbeOptions> probes;
  /// Called before files are written; throws FolderLost if that must not be.
  std::function<void()> require_folder = [] {};
};

/// Turns solved elements into snapshot_NNNN.vtkhdf (with snapshot.vtkhdf.series) and probe_NAME.csv.
/// Elements may arrive in any order: pieces are sorted by place, so the files are bitwise the same. An element is
/// evaluated when it is recorded and not kept. Snapshots that the front has not passed wait in memory. Not thread safe.
class Recorder {
 public:
  /// Throws std::invalid_argument for unknown fields, unsorted times or repeated probe names. Nothing is
  /// written before the first finish(), which replaces older files of the same names.
  explicit Recorder(RecorderOptions options);
  ~Recorder();
  Recorder(Recorder&&) noexcept;
  Recorder& operator=(Recorder&&) noexcept;

  /// Whether an element with this time range [s] and bounding box [m, D] can contribute; elements for which this is
  /// false need not be recorded, so their coefficients may stay on the device. Cheap.
  bool wants(double time_min, double time_max, std::span<const double> lower, std::span<const double> upper) const;

  /// Adds the element's slices and probe samples.
  void record(const SpacetimeElement& element);

  /// Writes every snapshot whose time the front has passed, and the probe rows. Call with the lowest front time [s]; at
  /// the end with the end time. Throws std::runtime_error if a probe lies in no element.
  void finish(double front_minimum_time);

  /// What a checkpoint needs to go on bitwise: pending pieces, samples and positions in the files. After `load` the
  /// output goes on from there; the options must be the same.
  void save(std::ostream& stream) const;
  void load(std::istream& stream);

  /// The files written so far.
  void add_written(WrittenFiles& files) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tentpole
