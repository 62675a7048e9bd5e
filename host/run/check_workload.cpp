#include "host/run/check_workload.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "host/case_file/number_text.hpp"
#include "host/fracture/defect_load.hpp"
#include "host/mesh/printed_number.hpp"

namespace tentpole {
namespace {

/// More take centuries on thousands of processors, and as many above each other drown in the rounding of times.
constexpr double most_tents = 1e15;
/// Shorter edges, as part of the domain, drown in the rounding of coordinates.
constexpr double smallest_part = 1e-12;

double longest_extent(const SpaceMesh& mesh) {
  double longest = 0;
  for (int axis = 0; axis < mesh.dimension; ++axis) {
    const auto [low, high] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                                                 [&](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    longest = std::max(longest, (*high)[axis] - (*low)[axis]);
  }
  return longest;
}

/// In scaled units a mean cell is 1 wide and the fastest wave has the speed 1.
void check_tents(const Simulation& simulation, const auto& report) {
  const double poles = simulation.scaled_end_time() / simulation.settings.front.causality;
  const double tents = poles * simulation.mesh.num_vertices();
  const double largest_tower = poles * simulation.scaling.length / simulation.smallest_edge;
  if (std::max(tents, largest_tower) <= most_tents) return;
  report("time.end", number_text(simulation.settings.end_time),
         "takes about " + printed(tents) + " tents, " + printed(largest_tower) +
             " of them at the smallest cell; at most 1e15 are possible: a wave passes a mean cell of " +
             printed(simulation.scaling.length) + " m in " + printed(simulation.scaling.time()) +
             " s, and front.causality is " + number_text(simulation.settings.front.causality) +
             ". Give an earlier end or larger cells, and look at the units of [domain] and [material].");
}

void check_smallest_size(const Simulation& simulation, const auto& report) {
  const AdaptivitySettings& adaptivity = simulation.settings.adaptivity;
  const double extent = longest_extent(simulation.mesh) * simulation.scaling.length;
  if (!adaptivity.enabled || adaptivity.min_size >= smallest_part * extent) return;
  report("adaptivity.min_size", number_text(adaptivity.min_size),
         "is less than 1e-12 of the domain, which is " + printed(extent) +
             " m long: cells of that size have no shape in double precision. Give a larger min_size.");
}

void check_defects(const Simulation& simulation, const auto& report) {
  const FractureSettings& fracture = simulation.settings.fracture;
  const SpaceMesh& mesh = simulation.mesh;
  if (!fracture.enabled || fracture.nucleation.model == NucleationModel::nowhere) return;
  double largest = 0;
  for (int cell = 0; cell < mesh.num_cells(); ++cell) largest = std::max(largest, mesh.cell_measure(cell));
  const double measure = largest * std::pow(simulation.scaling.length, mesh.dimension);
  const double mean = mean_defects_searched(mesh.dimension, fracture.nucleation, measure, fracture.strength);
  if (mean <= most_defects_per_cell) return;
  report("fracture.nucleation.density", number_text(fracture.nucleation.density),
         "makes a search through about " + printed(mean) + " defects for those weaker than fracture.strength = " +
             number_text(fracture.strength) + " Pa in the largest cell, whose measure is " + printed(measure) + " m^" +
             std::to_string(mesh.dimension) + "; at most " + printed(most_defects_per_cell) +
             " are possible. Give a smaller density, a larger minimum or smaller cells.");
}

}  // namespace

void check_workload(const Simulation& simulation) {
  std::vector<Problem> problems;
  const auto report = [&](const std::string& key, const std::string& value, const std::string& reason) {
    problems.push_back({{simulation.settings.path.string(), 0, 0, key, value}, reason});
  };
  check_tents(simulation, report);
  check_smallest_size(simulation, report);
  check_defects(simulation, report);
  if (!problems.empty()) throw InputError(problems);
}

}  // namespace tentpole
