#include "host/run/make_simulation.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "host/mesh/box_mesh.hpp"
#include "host/mesh/gmsh_file.hpp"
#include "host/mesh/simplex_geometry.hpp"
#include "host/problem/mesh_names.hpp"
#include "host/run/memory_need.hpp"

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
  if (!domain.is_box())
    return read_gmsh_file(domain.mesh_file.string(), domain.dimension, periodic_pairs(settings), name_use(settings));
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
  if (settings.domain.is_box()) {
    const BoxCounts counts = box_counts(settings.domain);
    check_memory(settings, counts.vertices, counts.cells);
  }
  simulation.mesh = make_mesh(settings);
  SpaceMesh& mesh = simulation.mesh;
  check_memory(settings, mesh.num_vertices(), mesh.num_cells());
  check_mesh_names(settings, mesh);
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

}  // namespace tentpole
