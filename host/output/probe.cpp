#include "host/output/probe.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "common/binary_stream.hpp"
#include "common/simplex.hpp"
#include "host/output/output_times.hpp"

namespace tentpole {
namespace {

/// A point this far outside an element, in barycentric coordinates, still counts as on its facet.
constexpr double facet_tolerance = 1e-9;

std::string header(int dimension) {
  constexpr std::array<const char*, 6> stress_names = {"sxx", "syy", "szz", "sxy", "syz", "sxz"};
  const std::string axes = "xyz";
  std::string line = "time";
  for (const char* vector : {",u", ",v"})
    for (int i = 0; i < dimension; ++i) line += std::string(vector) + axes[i];
  std::array<const char*, 6> present{};
  for (int i = 0; i < dimension; ++i)
    for (int j = i; j < dimension; ++j)
      present[symmetric_index(dimension, i, j)] = stress_names[symmetric_index(3, i, j)];
  for (int component = 0; component < num_symmetric(dimension); ++component)
    line += std::string(",") + present[component];
  return line;
}

const std::string& checked_name(const std::string& name) {
  if (name.empty() || name.find_first_of("/\\\n,") != std::string::npos)
    throw std::invalid_argument("probe \"" + name + "\": the name becomes part of a file name; use letters and digits");
  return name;
}

bool contains(const ElementFields& fields, int dimension, std::span<const double> event) {
  const auto xi = fields.reference_point(event);
  double last = 1;
  for (int l = 0; l <= dimension; ++l) {
    if (!(xi[l] >= -facet_tolerance)) return false;
    last -= xi[l];
  }
  return last >= -facet_tolerance;
}

}  // namespace

Probe::Probe(int dimension, const OutputFolder& folder, ProbeOptions options)
    : dimension_(dimension),
      options_(std::move(options)),
      file_(folder, "probe_" + checked_name(options_.name) + ".csv", header(dimension)),
      samples_(options_.times.size()) {
  check_output_times(options_.times, "probe " + options_.name);
}

bool Probe::wants(double time_min, double time_max, std::span<const double> lower,
                  std::span<const double> upper) const {
  for (int i = 0; i < dimension_; ++i) {
    const double margin = facet_tolerance * (dimension_ + 1) * (upper[i] - lower[i]);
    if (options_.point[i] < lower[i] - margin || options_.point[i] > upper[i] + margin) return false;
  }
  return !covered_times(options_.times, time_min, time_max).empty();
}

void Probe::record(const SpacetimeElement& element, const ElementFields& fields) {
  const OutputRange indices = covered_times(options_.times, element.time_min(), element.time_max());
  const auto place = element.centroid();
  for (int index = std::max(indices.first, num_written_); index < indices.last; ++index) {
    std::array<double, 4> event{options_.point[0], options_.point[1], options_.point[2], 0};
    event[dimension_] = options_.times[index];
    const auto point = std::span<const double>(event).first(dimension_ + 1);
    Sample& sample = samples_[index];
    if (sample.present && std::tie(sample.place, sample.id) < std::tie(place, element.id)) continue;
    if (contains(fields, dimension_, point)) sample = {place, element.id, 1, fields.at(point)};
  }
}

std::string Probe::row(double time, const PointFields& fields) const {
  std::string line;
  append_number(line, time);
  const auto append = [&](double value) {
    line += ',';
    append_number(line, value);
  };
  for (int i = 0; i < dimension_; ++i) append(fields.displacement[i]);
  for (int i = 0; i < dimension_; ++i) append(fields.velocity[i]);
  std::array<double, 6> stress{};
  for (int i = 0; i < dimension_; ++i)
    for (int j = i; j < dimension_; ++j)
      stress[symmetric_index(dimension_, i, j)] = fields.stress[symmetric_index(3, i, j)];
  for (int component = 0; component < num_symmetric(dimension_); ++component) append(stress[component]);
  return line + '\n';
}

void Probe::finish(double front_minimum_time) {
  std::string lines;
  for (; num_written_ < static_cast<int>(samples_.size()); ++num_written_) {
    const double time = options_.times[num_written_];
    if (!front_has_passed(front_minimum_time, time)) break;
    Sample& sample = samples_[num_written_];
    if (!sample.present) {
      std::string message = "probe \"" + options_.name + "\": the point (";
      for (int i = 0; i < dimension_; ++i) append_number(message += i > 0 ? ", " : "", options_.point[i]);
      append_number(message += ") m lies in no element at t = ", time);
      throw std::runtime_error(message + " s. Move it into the domain.");
    }
    lines += row(time, sample.fields);
    sample = {};
  }
  if (!lines.empty()) file_.append(lines);
}

void Probe::save(std::ostream& stream) const {
  file_.save(stream);
  write_value(stream, num_written_);
  write_vector(stream, samples_);
}

void Probe::load(std::istream& stream) {
  file_.load(stream);
  num_written_ = read_number(stream, static_cast<int>(samples_.size()), "the number of written samples");
  std::vector<Sample> samples = read_vector<Sample>(stream);
  if (samples.size() != samples_.size())
    throw std::runtime_error("probe \"" + options_.name + "\": the checkpoint has " + std::to_string(samples.size()) +
                             " sample times and the case " + std::to_string(samples_.size()) +
                             "; resume with the case file of the checkpoint");
  samples_ = std::move(samples);
}

}  // namespace tentpole
