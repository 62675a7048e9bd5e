#include "host/solver/simulation.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "host/mesh/box_mesh.hpp"
#include "host/mesh/gmsh_file.hpp"
#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {
namespace {

PeriodicPairs periodic_pairs(const Case& settings) {
  PeriodicPairs pairs;
  for (const auto& [name, condition] : settings.boundaries)
    if (condition.is_periodic() && name < condition.periodic_partner())
      pairs.emplace_back(name, condition.periodic_partner());
  return pairs;
}

SpaceMesh make_mesh(const Case& settings) {
  const DomainSettings& domain = settings.domain;
  if (!domain.is_box()) return read_gmsh_file(domain.mesh_file.string(), domain.dimension, periodic_pairs(settings));
  BoxMesh box;
  box.dimension = domain.dimension;
  box.min = domain.min;
  box.max = domain.max;
  box.cells = domain.cells;
  box.pattern = domain.pattern;
  box.seed = domain.seed;
  box.periodic = periodic_pairs(settings);
  return make_box_mesh(box);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Every name of the mesh needs an entry of the case, and every entry must exist in the mesh.
void check_names(const Case& settings, const SpaceMesh& mesh) {
  std::vector<Problem> problems;
  const auto report = [&](const std::string& key, const std::string& reason) {
    problems.push_back({{settings.path.string(), 0, 0, key, ""}, reason});
  };
  for (const std::string& name : mesh.boundary_names)
    if (!settings.boundaries.count(name))
      report("boundary." + name,
             "the mesh has this boundary and the case no condition for it. Add [boundary." + name + "].");
  for (const auto& [name, condition] : settings.boundaries)
    if (!condition.is_periodic() && !contains(mesh.boundary_names, name))
      report("boundary." + name, "the mesh has no such boundary (it has: " + listed(mesh.boundary_names) +
                                     "). Remove the table or name one of these.");
  for (const std::string& name : mesh.region_names)
    if (!settings.materials.count(name) && !settings.materials.count("all"))
      report("material." + name,
             "the mesh has this region and the case no material for it. Add [material." + name + "].");
  for (const auto& [name, properties] : settings.materials)
    if (name != "all" && !contains(mesh.region_names, name))
      report("material." + name, "the mesh has no such region (it has: " + listed(mesh.region_names) +
                                     "). Remove the table or name one of these.");
  if (!problems.empty()) throw InputError(problems);
}

Scaling make_scaling(const SpaceMesh& mesh, const std::vector<Material>& materials) {
  Scaling scaling{mesh.mean_cell_size(), 0, materials.front().density, mesh.dimension};
  for (const Material& material : materials) scaling.speed = std::max(scaling.speed, material.dilatational_speed());
  return scaling;
}

/// Shortest and longest edge.
std::pair<double, double> edge_range(const SpaceMesh& mesh) {
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  for (int cell = 0; cell < mesh.num_cells(); ++cell)
    for (int i = 0; i <= mesh.dimension; ++i)
      for (int j = 0; j < i; ++j) {
        const double length = distance(mesh.corner_position(cell, i), mesh.corner_position(cell, j));
        smallest = std::min(smallest, length);
        largest = std::max(largest, length);
      }
  return {smallest, largest};
}

}  // namespace

Simulation make_simulation(Case settings) {
  Simulation simulation;
  simulation.mesh = make_mesh(settings);
  SpaceMesh& mesh = simulation.mesh;
  check_names(settings, mesh);
  for (const std::string& name : mesh.region_names)
    simulation.materials.push_back(settings.material(settings.materials.count(name) ? name : "all"));
  for (const std::string& name : mesh.boundary_names) simulation.conditions.push_back(settings.boundaries.at(name));
  simulation.scaling = make_scaling(mesh, simulation.materials);
  std::tie(simulation.smallest_edge, simulation.largest_edge) = edge_range(mesh);
  mesh.scale_lengths(1 / simulation.scaling.length);
  for (const Material& material : simulation.materials)
    simulation.scaled_materials.push_back(simulation.scaling.scaled(material));
  for (const std::int32_t region : mesh.cell_region)
    simulation.cell_wave_speed.push_back(simulation.scaled_materials[region].dilatational_speed());
  simulation.warnings = settings.warnings;
  simulation.warnings.insert(simulation.warnings.end(), mesh.warnings.begin(), mesh.warnings.end());
  simulation.settings = std::move(settings);
  return simulation;
}

FractureLaw scaled_fracture_law(const Simulation& simulation) {
  const FractureSettings& fracture = simulation.settings.fracture;
  const Scaling& scaling = simulation.scaling;
  return {fracture.threshold / scaling.stress(),
          fracture.strength / scaling.stress(),
          fracture.relaxation_time / scaling.time(),
          fracture.delay_exponent,
          fracture.shear_factor,
          fracture.friction};
}

}  // namespace tentpole
