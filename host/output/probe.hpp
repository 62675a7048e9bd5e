#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "host/output/csv_file.hpp"
#include "host/output/output_folder.hpp"
#include "host/output/spacetime_element.hpp"
#include "host/output/time_coverage.hpp"

namespace tentpole {

/// A point whose fields are written over time.
struct ProbeOptions {
  std::string name;
  std::array<double, 3> point{};  ///< [m]
  std::vector<double> times;      ///< [s], strictly ascending
};

/// The file probe_NAME.csv: time, u [m], v [m/s], stress [Pa] in the components that the dimension has. A point on
/// facets takes, among the elements that meet there, the one with the smallest centroid (x first).
class Probe {
 public:
  /// Throws std::invalid_argument for times out of order or a name that cannot be part of a file name.
  Probe(int dimension, const OutputFolder& folder, ProbeOptions options);

  /// Memory that every sample time takes from the beginning to the end of a run.
  static constexpr std::size_t bytes_per_row() { return sizeof(Sample) + sizeof(double); }

  const std::string& name() const { return options_.name; }

  /// Whether an element with this time range and bounding box [D] may contain the point at a sample time.
  bool wants(double time_min, double time_max, std::span<const double> lower, std::span<const double> upper) const;

  /// Samples the element at the times it covers where the point lies in it.
  void record(const SpacetimeElement& element, const ElementFields& fields);

  /// Appends the rows that the front has passed. Throws std::runtime_error if the point lies in no recorded element.
  void finish(double front_minimum_time);

  void save(std::ostream& stream) const;
  void load(std::istream& stream);
  void add_written(WrittenFiles& files) const { file_.add_written(files); }

 private:
  struct Sample {
    std::array<double, 4> place{};  ///< centroid of the element it is from
    std::int64_t id = 0;
    std::uint8_t present = 0;
    PointFields fields;

    bool is_sound() const { return present <= 1; }
  };

  std::string row(double time, const PointFields& fields) const;

  int dimension_;
  ProbeOptions options_;
  CsvFile file_;
  std::vector<Sample> samples_;  ///< [times]
  int num_written_ = 0;
};

}  // namespace tentpole
