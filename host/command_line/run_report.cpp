#include "host/command_line/run_report.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "device/stage_timer.hpp"
#include "host/command_line/quantity.hpp"
#include "host/command_line/text_table.hpp"
#include "host/mesh/printable.hpp"

namespace tentpole {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string percent_text(double part, double total) {
  char text[16];
  std::snprintf(text, sizeof text, "%.1f %%", total > 0 ? 100 * part / total : 0);
  return text;
}

std::string stage_rows(const RunSummary::Stages& stages) {
  const std::pair<const char*, StageTime> named[] = {{"initialization", stages.initialization},
                                                     {"meshing", stages.meshing},
                                                     {"assembly", stages.assembly},
                                                     {"solution", stages.solution},
                                                     {"post-solution", stages.post_solution},
                                                     {"transfer", stages.transfer},
                                                     {"fracture", stages.fracture},
                                                     {"output", stages.output},
                                                     {"total", stages.total}};
  Rows rows;
  const double total = stages.total.seconds;
  for (const auto& [name, stage] : named)
    rows.push_back({name, duration_text(stage.seconds), percent_text(stage.seconds, total)});
  return "stages (those of host and device overlap)\n" + text_table(rows, "lrr");
}

/// Largest share of the energy budget, against which a balance error is judged.
double largest_energy(const RunSummary::Energy& energy) {
  return std::max({std::abs(energy.initial), std::abs(energy.external_work), std::abs(energy.kinetic),
                   std::abs(energy.strain), std::abs(energy.fracture), std::abs(energy.friction),
                   std::abs(energy.numerical)});
}

std::string energy_rows(const RunSummary& summary) {
  const char* const units[] = {"", "J/m^2", "J/m", "J"};
  const RunSummary::Energy& energy = summary.energy;
  Rows rows{{"initial", short_number(energy.initial)},         {"external work", short_number(energy.external_work)},
            {"kinetic", short_number(energy.kinetic)},         {"strain", short_number(energy.strain)},
            {"fracture", short_number(energy.fracture)},       {"friction", short_number(energy.friction)},
            {"numerical loss", short_number(energy.numerical)}};
  const double largest = largest_energy(energy);
  std::string error = short_number(energy.balance_error());
  if (largest > 0) error += "  (" + short_number(std::abs(energy.balance_error()) / largest) + " of the largest)";
  rows.push_back({"balance error", error});
  return "energy [" + std::string(units[summary.dimension]) + "]\n" + text_table(rows, "ll");
}

std::string fracture_rows(const RunSummary::Fracture& fracture, int dimension) {
  const std::string length = dimension == 1 ? "" : " m";
  return "fracture\n" +
         text_table(
             {{"nucleations, extensions", count_text(fracture.nucleations) + ", " + count_text(fracture.extensions)},
              {"branches, coalescences", count_text(fracture.branches) + ", " + count_text(fracture.coalescences)},
              {"failed surface (damage >= 0.999)", short_number(fracture.crack_length) + length},
              {"damage, mean and largest",
               short_number(fracture.damage_mean) + ", " + short_number(fracture.damage_max)},
              {"fragments", count_text(std::ssize(fracture.fragments))}},
             "ll");
}

std::string error_rows(const RunSummary::Errors& errors) {
  return "errors against [exact]\n" +
         text_table({{"displacement, L2 in spacetime", short_number(errors.displacement_l2)},
                     {"the same, relative", short_number(errors.displacement_l2_relative)},
                     {"energy norm", short_number(errors.energy_norm)}},
                    "ll");
}

std::string counts_line(const RunSummary& summary) {
  const RunSummary::Counts& counts = summary.counts;
  const double total = summary.stages.total.seconds;
  std::string text = count_text(counts.patches) + " patches, " + count_text(counts.elements) + " elements, " +
                     count_text(counts.dofs) + " unknowns in " + duration_text(total);
  if (total > 0) text += " (" + count_text(std::llround(static_cast<double>(counts.patches) / total)) + " patches/s)";
  return text + "\n";
}

}  // namespace

std::string cell_kind_text(int dimension) {
  const char* const kinds[] = {"", "intervals", "triangles", "tetrahedra"};
  return kinds[dimension];
}

std::string header_text(const Simulation& simulation, const Device& device, const ThreadChoice& choice) {
  const SpaceMesh& mesh = simulation.mesh;
  const int dimension = mesh.dimension;
  const int num_unknowns = dimension * num_polynomials(dimension + 1, simulation.degree());
  const bool on_cores = device.kind != DeviceKind::gpu;
  const int num_threads = on_cores ? choice.threads : device.num_threads;
  const std::string reason = on_cores && !choice.reason.empty() ? " (" + choice.reason + ")" : "";
  const std::string number = device.is_host ? "" : std::to_string(device.number) + ": ";
  return printable(simulation.settings.title) + "\n" +
         text_table({{"mesh", std::to_string(dimension) + "D, " + count_text(mesh.num_cells()) + " " +
                                  cell_kind_text(dimension) + ", shortest edge " +
                                  short_number(simulation.smallest_edge) + " m"},
                     {"degree", std::to_string(simulation.degree()) + ", " + std::to_string(num_unknowns) +
                                    " unknowns per spacetime element"},
                     {"end", short_number(simulation.settings.end_time) + " s"},
                     {"device", number + device.name + ", " + count_text(num_threads) +
                                    (num_threads == 1 ? " thread" : " threads") + reason}},
                    "ll");
}

std::string summary_text(const RunSummary& summary) {
  std::string text = counts_line(summary) + stage_rows(summary.stages) + energy_rows(summary);
  // A whole body without fracture is one fragment or none that anybody looked for.
  if (summary.fracture.nucleations > 0 || summary.fracture.damage_max > 0 || summary.fracture.spalled())
    text += fracture_rows(summary.fracture, summary.dimension);
  if (summary.errors) text += error_rows(*summary.errors);
  if (summary.traffic.launches > 0)
    text += "traffic\n  " + bytes_text(static_cast<double>(summary.traffic.bytes_to_device)) + " to the device, " +
            bytes_text(static_cast<double>(summary.traffic.bytes_from_device)) + " back, " +
            count_text(summary.traffic.launches) + " launches\n";
  return text;
}

std::string files_text(const std::filesystem::path& folder) {
  Rows rows;
  std::int64_t num_snapshots = 0, num_crack_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("snapshot_") && name.ends_with(".vtkhdf")) ++num_snapshots;
    if (name.starts_with("cracks_") && name.ends_with(".vtkhdf")) ++num_crack_files;
    if (name == "summary.json") rows.push_back({name, "counts, times, energies, errors"});
    if (name == "history.csv") rows.push_back({name, "energies over time"});
    if (name == "checkpoint.h5") rows.push_back({name, "go on with --resume"});
    if (name.starts_with("probe_")) rows.push_back({name, "displacement, velocity and stress at a point"});
  }
  if (num_snapshots > 0)
    rows.push_back({"snapshot.vtkhdf.series", count_text(num_snapshots) + " snapshots, opens in ParaView"});
  if (num_crack_files > 0)
    rows.push_back(
        {"cracks.vtkhdf.series", count_text(num_crack_files) + " files of fracture edges, opens in ParaView"});
  std::sort(rows.begin(), rows.end());
  const std::string place = printable(folder.string());
  return "files in " + place + "\n" + text_table(rows, "ll") + "pictures: tentpole plot " + place + "\n";
}

}  // namespace tentpole
