#include "host/output/history.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "common/binary_stream.hpp"
#include "common/exact_sum.hpp"
#include "host/output/csv_file.hpp"
#include "host/output/output_times.hpp"

namespace tentpole {
namespace {

constexpr const char* header =
    "time,kinetic,strain,external_work,numerical,fracture,friction,crack_length,damage_mean,damage_max,nucleations,"
    "extensions,branches,coalescences,fragments,cells,smallest_cell";

struct FlowSums {
  ExactSum external_work, numerical, fracture, friction;

  void add(const EnergyFlow& flow, double share) {
    external_work += share * flow.external_work;
    numerical += share * flow.numerical;
    fracture += share * flow.fracture;
    friction += share * flow.friction;
  }
  void add(const FlowSums& other) {
    external_work += other.external_work;
    numerical += other.numerical;
    fracture += other.fracture;
    friction += other.friction;
  }
  bool is_sound() const {
    return external_work.is_sound() && numerical.is_sound() && fracture.is_sound() && friction.is_sound();
  }
};

struct SurfaceSums {
  ExactSum length, failed, damage;  ///< measures; of what has failed; times mean damage
  double damage_max = 0;

  bool is_sound() const {
    return length.is_sound() && failed.is_sound() && damage.is_sound() && std::isfinite(damage_max);
  }
};

using EventCounts = std::array<std::int64_t, 4>;

/// Whether sums of them stay counts.
bool are_counts(const EventCounts& events) {
  return std::ranges::all_of(events, [](std::int64_t count) { return count >= 0 && count < std::int64_t{1} << 40; });
}

struct Row {
  ExactSum kinetic, strain;
  SurfaceSums surfaces;
  EventCounts events{};  ///< since the row before
  FlowSums partial;      ///< shares of flows that this row cuts
  FlowSums complete;     ///< flows that are complete at this row and not at the row before

  bool is_sound() const {
    return kinetic.is_sound() && strain.is_sound() && surfaces.is_sound() && are_counts(events) && partial.is_sound() &&
           complete.is_sound();
  }
};

}  // namespace

struct History::Impl {
  CsvFile file;
  std::vector<double> times;
  std::vector<Row> rows;
  FlowSums passed;       ///< flows complete at the last written row
  EventCounts events{};  ///< up to the last written row
  int num_written = 0;

  Row& open_row(int row);
  std::string line(int index, const FlowSums& cumulative, const FrontState& state) const;
};

std::string History::Impl::line(int index, const FlowSums& cumulative, const FrontState& state) const {
  const Row& row = rows[index];
  const double length = row.surfaces.length.value();
  std::string text;
  for (const double value :
       {times[index], row.kinetic.value(), row.strain.value(), cumulative.external_work.value(),
        cumulative.numerical.value(), cumulative.fracture.value(), cumulative.friction.value(),
        row.surfaces.failed.value(), length > 0 ? row.surfaces.damage.value() / length : 0, row.surfaces.damage_max}) {
    append_number(text, value);
    text += ',';
  }
  for (const std::int64_t count : events) text += std::to_string(count) + ',';
  for (const std::int64_t count : {state.fragments, state.cells}) text += std::to_string(count) + ',';
  append_number(text, state.smallest_cell);
  return text + '\n';
}

History::History(const OutputFolder& folder, double interval, double end) {
  std::vector<double> times = times_at_interval(interval, end);
  impl_ = std::make_unique<Impl>(Impl{.file = CsvFile(folder, "history.csv", header),
                                      .times = times,
                                      .rows = std::vector<Row>(times.size()),
                                      .passed = {},
                                      .events = {},
                                      .num_written = 0});
}

History::~History() = default;
History::History(History&&) noexcept = default;
History& History::operator=(History&&) noexcept = default;

std::size_t History::bytes_per_row() {
  return sizeof(Row) + sizeof(double);
}

const std::vector<double>& History::times() const {
  return impl_->times;
}

OutputRange History::rows(double time_min, double time_max) const {
  return covered_times(impl_->times, time_min, time_max);
}

Row& History::Impl::open_row(int row) {
  if (row < num_written || row >= static_cast<int>(rows.size()))
    throw std::logic_error("history row " + std::to_string(row) + " is written already or does not exist");
  return rows[row];
}

void History::add_energy(int row, double kinetic, double strain) {
  Row& open = impl_->open_row(row);
  open.kinetic += kinetic;
  open.strain += strain;
}

void History::add_surface(int row, double measure, const CrackEdgeState& part) {
  SurfaceSums& surfaces = impl_->open_row(row).surfaces;
  surfaces.length += measure;
  surfaces.failed += measure * failed_fraction(part);
  surfaces.damage += measure * mean_damage(part);
  surfaces.damage_max = std::max(surfaces.damage_max, largest_damage(part));
}

void History::add_event(CrackEvent event, double time) {
  const auto row = std::lower_bound(impl_->times.begin(), impl_->times.end(), time) - impl_->times.begin();
  const auto open = std::max<std::ptrdiff_t>(row, impl_->num_written);
  if (open < std::ssize(impl_->rows)) ++impl_->rows[open].events[static_cast<std::size_t>(event)];
}

void History::add_interval(double time_min, double time_max, const EnergyFlow& flow) {
  const auto& times = impl_->times;
  if (!(time_min < time_max))
    throw std::logic_error("energy flow over an empty time range at t = " + std::to_string(time_min) + " s");
  const auto first = std::upper_bound(times.begin(), times.end(), time_min) - times.begin();
  const auto last = std::lower_bound(times.begin(), times.end(), time_max) - times.begin();
  if (first < impl_->num_written)
    throw std::logic_error("energy flow from t = " + std::to_string(time_min) +
                           " s belongs to history rows already written");
  for (auto row = first; row < last; ++row)
    impl_->rows[row].partial.add(flow, (times[row] - time_min) / (time_max - time_min));
  // Flows that end after the last row have no row in which they are complete.
  if (last < static_cast<std::ptrdiff_t>(times.size())) impl_->rows[last].complete.add(flow, 1);
}

void History::finish(double front_minimum_time, const FrontState& state) {
  std::string lines;
  int& index = impl_->num_written;
  for (; index < static_cast<int>(impl_->rows.size()); ++index) {
    if (!front_has_passed(front_minimum_time, impl_->times[index])) break;
    impl_->passed.add(impl_->rows[index].complete);
    FlowSums cumulative = impl_->passed;
    cumulative.add(impl_->rows[index].partial);
    for (std::size_t event = 0; event < impl_->events.size(); ++event)
      impl_->events[event] += impl_->rows[index].events[event];
    lines += impl_->line(index, cumulative, state);
  }
  if (!lines.empty()) impl_->file.append(lines);
}

void History::save(std::ostream& stream) const {
  impl_->file.save(stream);
  write_value(stream, impl_->num_written);
  write_value(stream, impl_->passed);
  write_value(stream, impl_->events);
  write_vector(stream, impl_->rows);
}

void History::load(std::istream& stream) {
  impl_->file.load(stream);
  impl_->num_written = read_number(stream, static_cast<int>(impl_->rows.size()), "the number of written rows");
  impl_->passed = read_value<FlowSums>(stream);
  impl_->events = read_value<EventCounts>(stream);
  require_sound(stream, are_counts(impl_->events), "a count of events is out of its range");
  std::vector<Row> rows = read_vector<Row>(stream);
  if (rows.size() != impl_->rows.size())
    throw std::runtime_error("the checkpoint has " + std::to_string(rows.size()) + " history rows and the case " +
                             std::to_string(impl_->rows.size()) + "; resume with the case file of the checkpoint");
  impl_->rows = std::move(rows);
}

void History::add_written(WrittenFiles& files) const {
  impl_->file.add_written(files);
}

}  // namespace tentpole
