#include "host/run/check_probes.hpp"

#include <algorithm>
#include <vector>

#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {
namespace {

/// As host/output/probe.cpp: this far outside a cell, in barycentric coordinates, still counts as on its facet.
constexpr double facet_tolerance = 1e-9;

using Corners = std::array<Point, SpaceMesh::max_corners>;

bool lies_in_box(int dimension, const Corners& corners, const Point& point) {
  for (int axis = 0; axis < dimension; ++axis) {
    double low = corners[0][axis], high = low;
    for (int i = 1; i <= dimension; ++i) {
      low = std::min(low, corners[i][axis]);
      high = std::max(high, corners[i][axis]);
    }
    const double margin = facet_tolerance * (high - low) * (dimension + 1);
    if (point[axis] < low - margin || point[axis] > high + margin) return false;
  }
  return true;
}

bool lies_in_cell(int dimension, const Corners& corners, const Point& point) {
  if (!lies_in_box(dimension, corners, point)) return false;
  const double measure = signed_simplex_measure(dimension, corners);
  for (int corner = 0; corner <= dimension; ++corner) {
    Corners part = corners;
    part[corner] = point;
    if (!(signed_simplex_measure(dimension, part) / measure >= -facet_tolerance)) return false;
  }
  return true;
}

/// Probes that are in no cell, by number.
std::vector<std::size_t> probes_outside(const Simulation& simulation) {
  const SpaceMesh& mesh = simulation.mesh;
  const std::vector<ProbeSettings>& probes = simulation.settings.output.probes;
  std::vector<Point> points;
  std::vector<std::size_t> outside;
  for (const ProbeSettings& probe : probes) {
    outside.push_back(points.size());
    Point& point = points.emplace_back(probe.point);
    for (double& coordinate : point) coordinate /= simulation.scaling.length;
  }
  for (int cell = 0; cell < mesh.num_cells() && !outside.empty(); ++cell) {
    Corners corners{};
    for (int i = 0; i <= mesh.dimension; ++i) corners[i] = mesh.corner_position(cell, i);
    std::erase_if(outside, [&](std::size_t probe) { return lies_in_cell(mesh.dimension, corners, points[probe]); });
  }
  return outside;
}

}  // namespace

void check_probes(const Simulation& simulation) {
  std::vector<Problem> problems;
  for (const std::size_t probe : probes_outside(simulation))
    problems.push_back({simulation.settings.output.probes[probe].point_location,
                        "lies in no cell of the mesh. Give a point inside the domain."});
  if (!problems.empty()) throw InputError(problems);
}

}  // namespace tentpole
