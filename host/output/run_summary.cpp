#include "host/output/run_summary.hpp"

#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "host/output/atomic_file.hpp"
#include "host/output/machine_info.hpp"

namespace tentpole {
namespace {

using Json = nlohmann::ordered_json;

/// Collects named numbers; those that are not finite become null and a warning.
class NumberWriter {
 public:
  explicit NumberWriter(std::vector<std::string> warnings) : warnings_(std::move(warnings)) {}

  void put(Json& object, const std::string& section, const std::string& name, double value) {
    if (std::isfinite(value)) {
      object[section][name] = value;
      return;
    }
    object[section][name] = nullptr;
    warnings_.push_back(section + "." + name + " is not finite (" + (std::isnan(value) ? "NaN" : "infinite") + ")");
  }

  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::vector<std::string> warnings_;
};

std::vector<std::pair<const char*, StageTime>> named_stages(const RunSummary::Stages& stages) {
  return {{"initialization", stages.initialization},
          {"meshing", stages.meshing},
          {"assembly", stages.assembly},
          {"solution", stages.solution},
          {"post_solution", stages.post_solution},
          {"transfer", stages.transfer},
          {"fracture", stages.fracture},
          {"output", stages.output},
          {"total", stages.total}};
}

void add_identity(const RunSummary& summary, Json& json) {
  const BuildInfo build = build_info();
  json["title"] = summary.title;
  json["version"] = build.version;
  json["git_revision"] = build.git_revision;
  json["formulation"] = summary.formulation;
  json["dimension"] = summary.dimension;
  json["degree"] = summary.degree;
  json["end_time"] = summary.end_time;
  json["device"] = summary.device;
  json["threads"] = summary.threads;
  json["seed"] = summary.seed;
}

void add_counts(const RunSummary::Counts& counts, Json& json, NumberWriter& numbers) {
  json["counts"] = {{"patches", counts.patches},
                    {"elements", counts.elements},
                    {"dofs", counts.dofs},
                    {"rejected", counts.rejected},
                    {"min_size_hits", counts.min_size_hits},
                    {"splits", counts.splits},
                    {"deletions", counts.deletions},
                    {"flips", counts.flips},
                    {"inclined", counts.inclined},
                    {"cells_min", counts.cells_min},
                    {"cells_max", counts.cells_max}};
  numbers.put(json, "counts", "smallest_cell", counts.smallest_cell);
  numbers.put(json, "counts", "largest_cell", counts.largest_cell);
  json["counts"]["batches"] = counts.batches;
  json["counts"]["dense_fallbacks"] = counts.dense_fallbacks;
}

void add_times(const RunSummary& summary, Json& json, NumberWriter& numbers) {
  const double total = summary.stages.total.seconds;
  const auto stages = named_stages(summary.stages);
  for (const auto& [name, stage] : stages) numbers.put(json, "time_s", name, stage.seconds);
  // A run that took no measurable time has no shares and no rates.
  if (!(total > 0)) return;
  for (const auto& [name, stage] : stages) numbers.put(json, "percent", name, 100 * stage.seconds / total);
  numbers.put(json, "rates", "patches_per_s", static_cast<double>(summary.counts.patches) / total);
  numbers.put(json, "rates", "dofs_per_s", static_cast<double>(summary.counts.dofs) / total);
  const double kernel_seconds =
      summary.stages.assembly.seconds + summary.stages.solution.seconds + summary.stages.post_solution.seconds;
  if (summary.flops && kernel_seconds > 0) numbers.put(json, "rates", "gflops", *summary.flops / kernel_seconds / 1e9);
}

void add_energy(const RunSummary::Energy& energy, Json& json, NumberWriter& numbers) {
  const std::pair<const char*, double> entries[] = {{"initial", energy.initial},
                                                    {"external_work", energy.external_work},
                                                    {"kinetic", energy.kinetic},
                                                    {"strain", energy.strain},
                                                    {"fracture", energy.fracture},
                                                    {"friction", energy.friction},
                                                    {"numerical", energy.numerical},
                                                    {"balance_error", energy.balance_error()},
                                                    {"largest_patch_increase", energy.largest_patch_increase},
                                                    {"largest_patch_imbalance", energy.largest_patch_imbalance}};
  for (const auto& [name, value] : entries) numbers.put(json, "energy", name, value);
}

void add_fracture(const RunSummary::Fracture& fracture, Json& json, NumberWriter& numbers) {
  json["fracture"] = {{"nucleations", fracture.nucleations},
                      {"extensions", fracture.extensions},
                      {"branches", fracture.branches},
                      {"coalescences", fracture.coalescences}};
  numbers.put(json, "fracture", "crack_length", fracture.crack_length);
  numbers.put(json, "fracture", "surface_length", fracture.surface_length);
  numbers.put(json, "fracture", "damage_mean", fracture.damage_mean);
  numbers.put(json, "fracture", "damage_max", fracture.damage_max);
  if (fracture.first_nucleation)
    json["fracture"]["first_nucleation"] = {{"time", fracture.first_nucleation->time},
                                            {"position", fracture.first_nucleation->position}};
  json["fracture"]["spalled"] = fracture.spalled();
  json["fracture"]["fragments"] = Json::array();
  for (const RunSummary::Fragment& fragment : fracture.fragments)
    json["fracture"]["fragments"].push_back(
        {{"size", fragment.size}, {"mass", fragment.mass}, {"mean_velocity", fragment.mean_velocity}});
}

void add_errors(const RunSummary::Errors& errors, Json& json, NumberWriter& numbers) {
  numbers.put(json, "errors", "displacement_l2", errors.displacement_l2);
  numbers.put(json, "errors", "displacement_l2_relative", errors.displacement_l2_relative);
  numbers.put(json, "errors", "energy_norm", errors.energy_norm);
}

void add_machine(Json& json) {
  const MachineInfo machine = machine_info();
  const BuildInfo build = build_info();
  json["machine"] = {
      {"processor", machine.processor}, {"cores", machine.cores}, {"peak_resident_bytes", machine.peak_resident_bytes}};
  json["build"] = {{"compiler", build.compiler},
                   {"type", build.type},
                   {"architecture", build.architecture},
                   {"instructions", build.instructions},
                   {"source_digest", build.source_digest}};
}

}  // namespace

double RunSummary::Energy::balance_error() const {
  return initial + external_work - kinetic - strain - fracture - friction - numerical;
}

void write_run_summary(const OutputFolder& folder, const RunSummary& summary) {
  Json json;
  NumberWriter numbers(summary.warnings);
  add_identity(summary, json);
  add_counts(summary.counts, json, numbers);
  add_times(summary, json, numbers);
  add_energy(summary.energy, json, numbers);
  add_fracture(summary.fracture, json, numbers);
  if (summary.errors) add_errors(*summary.errors, json, numbers);
  json["traffic"] = {{"bytes_to_device", summary.traffic.bytes_to_device},
                     {"bytes_from_device", summary.traffic.bytes_from_device},
                     {"launches", summary.traffic.launches}};
  add_machine(json);
  json["warnings"] = numbers.warnings();
  // Titles may hold any bytes; those that are not UTF-8 are replaced rather than refused.
  replace_text_file(folder, "summary.json", json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace tentpole
