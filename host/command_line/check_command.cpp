#include <algorithm>
#include <iostream>

#include "host/command_line/commands.hpp"
#include "host/command_line/quantity.hpp"
#include "host/command_line/run_report.hpp"
#include "host/command_line/tent_estimate.hpp"
#include "host/command_line/text_table.hpp"
#include "host/mesh/printable.hpp"
#include "kernels/patch_solver.hpp"

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

/// What a run on the host solves, and what it allocates for that: one element per front cell and the batch being
/// solved, and the scratch of each thread.
std::string work_text(const Simulation& simulation, int num_threads) {
  constexpr std::int64_t most_patches = 500'000;  // about a second
  const TentEstimate tents = estimate_tents(simulation, most_patches);
  const ReferenceTables tables(simulation.dimension(), simulation.degree());
  const double d = simulation.dimension() + 1, num_unknowns = tables.view().num_unknowns;
  const double store = simulation.mesh.num_cells() * (num_unknowns + d * d) * sizeof(double);
  const double scratch =
      static_cast<double>(patch_scratch_size(tables.view(), PatchDescriptor{0, tents.largest_patch}, 1)) * num_threads *
      sizeof(double);
  const std::string about = tents.is_exact ? "" : "about ";
  const bool keeps_mesh = !simulation.settings.adaptivity.enabled && !simulation.settings.fracture.enabled;
  return (keeps_mesh ? "work\n" : "work of the initial mesh, if it stayed as it is\n") +
         text_table({{"patches", about + count_text(tents.patches) + ", at most " +
                                     std::to_string(tents.largest_patch) + " elements each"},
                     {"elements", about + count_text(tents.elements)},
                     {"unknowns", about + count_text(tents.elements * static_cast<std::int64_t>(num_unknowns))},
                     {"memory", bytes_text(store) + " for the elements below the front, " + bytes_text(scratch) +
                                    " scratch of " + std::to_string(num_threads) +
                                    (num_threads == 1 ? " thread" : " threads")}},
                    "ll");
}

}  // namespace

int check_command(const CaseOptions& input) {
  const Simulation simulation = read_simulation(input);
  const Device device = host_device();
  const int num_threads = input.threads > 0 ? input.threads : device.num_threads;
  std::cout << header_text(simulation, device, num_threads) << materials_text(simulation) << boundaries_text(simulation)
            << work_text(simulation, num_threads) << printable(input.case_file.string()) << " is valid\n";
  return 0;
}

}  // namespace tentpole
