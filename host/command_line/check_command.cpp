#include <cmath>
#include <iostream>

#include "host/command_line/commands.hpp"
#include "host/command_line/quantity.hpp"
#include "host/command_line/run_report.hpp"
#include "host/command_line/text_table.hpp"
#include "host/fracture/strength_distribution.hpp"
#include "host/mesh/printable.hpp"
#include "host/run/memory_need.hpp"
#include "host/run/run.hpp"
#include "host/run/tent_estimate.hpp"
#include "kernels/launch/patch_solver.hpp"

namespace tentpole {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string materials_text(const Simulation& simulation) {
  Rows rows{{"region", "density [kg/m^3]", "c_p [m/s]", "c_s [m/s]"}};
  for (std::size_t region = 0; region < simulation.materials.size(); ++region) {
    const Material& material = simulation.materials[region];
    const bool has_shear = simulation.dimension() > 1;
    rows.push_back({simulation.mesh.region_names[region], short_number(material.density),
                    short_number(material.dilatational_speed()),
                    has_shear ? short_number(material.shear_speed()) : "-"});
  }
  return "materials\n" + text_table(rows, "lrrr");
}

std::string kind_text(BoundaryKind kind) {
  switch (kind) {
    case BoundaryKind::traction:
      return "traction";
    case BoundaryKind::velocity:
      return "velocity";
    case BoundaryKind::absorbing:
      return "absorbing";
  }
  return "";
}

/// What comes in through an absorbing side; nothing where that is nothing.
std::string far_field_text(const BoundaryCondition& condition, const Case& settings) {
  if (condition.has_far_field()) return condition.is_zero() ? ", far field zero" : ", far field given";
  const bool is_at_rest = settings.initial_displacement.is_zero() && settings.initial_velocity.is_zero();
  return is_at_rest ? "" : ", far field in the initial state";
}

std::string condition_text(const BoundaryCondition& condition, const Simulation& simulation) {
  const int dimension = simulation.dimension();
  const std::string normal = kind_text(condition.normal_kind()), tangential = kind_text(condition.tangential_kind());
  std::string text =
      dimension == 1 || normal == tangential ? normal : "normal " + normal + ", tangential " + tangential;
  if (condition.is_absorbing()) return text + far_field_text(condition, simulation.settings);
  if (condition.is_zero()) text += ", zero";
  if (condition.ramp().rise_time > 0) text += ", rising over " + short_number(condition.ramp().rise_time) + " s";
  return text;
}

std::string boundaries_text(const Simulation& simulation) {
  Rows rows;
  for (std::size_t boundary = 0; boundary < simulation.conditions.size(); ++boundary)
    rows.push_back(
        {simulation.mesh.boundary_names[boundary], condition_text(simulation.conditions[boundary], simulation)});
  for (const auto& [name, condition] : simulation.settings.boundaries)
    if (condition.is_periodic() && name < condition.periodic_partner())
      rows.push_back({name, "periodic with " + condition.periodic_partner()});
  return "boundaries\n" + text_table(rows, "ll");
}

/// The defects of a domain, and those that can give way before an interface does.
std::string defects_text(const Simulation& simulation) {
  const FractureSettings& fracture = simulation.settings.fracture;
  double measure = 0;
  for (int cell = 0; cell < simulation.mesh.num_cells(); ++cell) measure += simulation.mesh.cell_measure(cell);
  measure *= std::pow(simulation.scaling.length, simulation.dimension());
  const double all = fracture.nucleation.density * measure;
  const double weak = all * StrengthDistribution::from_settings(fracture.nucleation).probability(fracture.strength);
  const std::string each = fracture.nucleation.model == NucleationModel::sampled ? " at each test" : "";
  return "about " + short_number(all) + each + ", of them " + short_number(weak) + " weaker than fracture.strength";
}

std::string output_text(const Case& settings) {
  const auto rows = [&](double interval) { return estimate_text(std::ceil(settings.end_time / interval - 1e-6) + 1); };
  std::string text = count_text(std::ssize(settings.output.snapshot_times)) + " snapshots, history.csv with " +
                     rows(settings.output.history_interval) + " rows";
  for (const ProbeSettings& probe : settings.output.probes)
    text += ", probe_" + probe.name + ".csv with " + rows(probe.interval);
  return text;
}

/// What a run on the host solves and writes, and what it allocates for that: one element per front cell and the batch
/// being solved, and the scratch of each thread.
std::string work_text(const Simulation& simulation, int num_threads) {
  constexpr std::int64_t most_patches = 500'000;  // about a second
  const Case& settings = simulation.settings;
  const TentEstimate tents = estimate_tents(simulation, most_patches);
  const ReferenceTables tables(simulation.dimension(), simulation.degree());
  const double d = simulation.dimension() + 1, num_unknowns = tables.view().num_unknowns;
  const double store = simulation.mesh.num_cells() * (num_unknowns + d * d) * sizeof(double);
  const double scratch =
      static_cast<double>(patch_scratch_size(tables.view(), PatchDescriptor{0, tents.largest_patch}, 1)) * num_threads *
      sizeof(double);
  const double peak = memory_need(settings, simulation.mesh.num_vertices(), simulation.mesh.num_cells()).peak();
  const std::string about = tents.is_exact ? "" : "about ";
  const bool keeps_mesh = !settings.adaptivity.enabled && !settings.fracture.enabled;
  Rows rows{{"patches", about + estimate_text(tents.patches) + ", at most " + std::to_string(tents.largest_patch) +
                            " elements each"},
            {"elements", about + estimate_text(tents.elements)},
            {"unknowns", about + estimate_text(tents.elements * num_unknowns)},
            {"memory", bytes_text(store) + " for the elements below the front, " + bytes_text(scratch) +
                           " scratch of " + std::to_string(num_threads) + (num_threads == 1 ? " thread" : " threads")},
            {"", "about " + bytes_text(peak + scratch) + " in all"}};
  if (settings.fracture.enabled && settings.fracture.nucleation.model != NucleationModel::nowhere)
    rows.push_back({"defects", defects_text(simulation)});
  rows.push_back({"output", output_text(settings)});
  return (keeps_mesh ? "work\n" : "work of the initial mesh, if it stayed as it is\n") + text_table(rows, "ll");
}

}  // namespace

int check_command(const CheckCommand& command) {
  const CaseOptions& input = command.input;
  const Simulation simulation = read_simulation(input);
  const ThreadChoice choice = choose_threads(input);
  RunOptions options;
  options.device = choose_device(command.offload, command.device);
  options.threads = choice.threads;
  prepare_run(simulation, options);
  std::cout << header_text(simulation, options.device, choice) << materials_text(simulation)
            << boundaries_text(simulation) << work_text(simulation, choice.threads)
            << printable(input.case_file.string()) << " is valid\n";
  return 0;
}

}  // namespace tentpole
