#include <algorithm>
#include <cctype>
#include <set>

#include "host/case_file/field_names.hpp"
#include "host/case_file/number_text.hpp"
#include "host/case_file/sections.hpp"

namespace tentpole {
namespace {

constexpr int default_snapshots = 20;
constexpr double default_intervals = 200;  // records of probes and history per run
constexpr double most_records = 1e7;       // a file of more rows is a mistake

std::vector<double> evenly_spaced(std::int64_t count, double end) {
  std::vector<double> times;
  for (std::int64_t i = 1; i <= count; ++i) times.push_back(i == count ? end : end * static_cast<double>(i) / count);
  return times;
}

std::vector<double> read_snapshot_times(const TableReader& reader, double end) {
  if (reader.has("times") && reader.has("snapshots"))
    reader.report("times", "is given besides output.snapshots. Remove one of them.");
  if (!reader.has("times")) {
    const auto count = reader.integer("snapshots", Presence::optional,
                                      from_to(0, 100000, "Give the number of snapshots; 0 writes none."));
    return evenly_spaced(count.value_or(default_snapshots), end);
  }
  const Rule rule{[end](double time) { return time > 0 && (end == 0 || time <= end); },
                  "must lie in (0, time.end] = (0, " + number_text(end) + "]", "Give times of the run in s."};
  auto times = reader.numbers("times", Presence::required, 0, rule);
  if (!times) return {};
  if (std::adjacent_find(times->begin(), times->end(), std::greater_equal<>()) != times->end())
    reader.report("times", "must ascend. Sort the times and name each one once.");
  return *times;
}

std::vector<std::string> read_fields(const TableReader& reader, const SectionContext& context) {
  std::vector<std::string> fields;
  const auto given = reader.texts("fields", Presence::optional);
  if (!given) return OutputSettings().fields;
  std::string known;
  for (const std::string_view name : field_names) known += (known.empty() ? "" : ", ") + std::string(name);
  for (const std::string& name : *given) {
    if (std::find(field_names.begin(), field_names.end(), name) == field_names.end())
      reader.report("fields", "unknown field \"" + name + "\". Known: " + known + ".");
    else if (std::find(fields.begin(), fields.end(), name) == fields.end())
      fields.push_back(name);
    if (name == "damage" && !context.has_fracture)
      context.warnings.push_back(to_string(reader.location("fields")) +
                                 ": without fracture there is no damage to write.");
  }
  return fields;
}

double read_interval(const TableReader& reader, const std::string& key, double end) {
  const auto interval = reader.number(key, Presence::optional, positive("Give the time between two records in s."));
  if (interval && end > 0 && (*interval > end || end / *interval > most_records))
    reader.report(key, "must lie in [time.end / 1e7, time.end] with time.end = " + number_text(end) +
                           ". Give the time between two records in s.");
  return interval.value_or(end / default_intervals);
}

/// The name becomes part of a file name.
bool is_file_name(const std::string& name) {
  if (name.empty()) return false;
  return std::all_of(name.begin(), name.end(),
                     [](unsigned char letter) { return std::isalnum(letter) || letter == '_' || letter == '-'; });
}

ProbeSettings read_probe(const TableReader& reader, const SectionContext& context) {
  ProbeSettings probe;
  reader.allow_only({"name", "point", "interval"});
  if (const auto name = reader.text("name", Presence::required)) {
    probe.name = *name;
    if (!is_file_name(*name)) reader.report("name", "is part of a file name. Use letters, digits, _ and - only.");
  }
  const Rule any{[](double) { return true; }, "must be a length", "Give metres."};
  if (context.domain.dimension > 0) {
    const auto point = reader.numbers("point", Presence::required, context.domain.dimension, any);
    if (point && !lies_in_domain(context.domain, *point))
      reader.report("point", "lies outside the box of [domain]. Give a point between domain.min and domain.max.");
    if (point) std::copy(point->begin(), point->end(), probe.point.begin());
    probe.point_location = reader.location("point");
  }
  probe.interval = read_interval(reader, "interval", context.end_time);
  return probe;
}

std::vector<ProbeSettings> read_probes(const TableReader& output, const SectionContext& context) {
  std::vector<ProbeSettings> probes;
  std::set<std::string> names;
  for (const Node* table : output.tables_in_array("probe")) {
    const TableReader reader(*table, context.problems);
    probes.push_back(read_probe(reader, context));
    if (!probes.back().name.empty() && !names.insert(probes.back().name).second)
      reader.report("name", "is the name of an earlier probe. Choose another one.");
  }
  return probes;
}

}  // namespace

OutputSettings read_output(const SectionContext& context) {
  const TableReader reader = context.section("output");
  reader.allow_only({"snapshots", "times", "fields", "history_interval", "probe"});
  OutputSettings output;
  output.snapshot_times = read_snapshot_times(reader, context.end_time);
  output.fields = read_fields(reader, context);
  output.probes = read_probes(reader, context);
  output.history_interval = read_interval(reader, "history_interval", context.end_time);
  return output;
}

}  // namespace tentpole
