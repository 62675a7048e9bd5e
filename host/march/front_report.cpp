#include "host/march/front_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {
namespace {

/// Cells in use, and the index of each among them.
struct CellList {
  std::vector<std::int32_t> cells, index;
};

CellList cells_in_use(const FrontMesh& mesh) {
  CellList list;
  list.index.assign(mesh.num_cell_slots(), none);
  for (int cell = 0; cell < mesh.num_cell_slots(); ++cell)
    if (mesh.is_alive_cell(cell)) {
      list.index[cell] = static_cast<std::int32_t>(list.cells.size());
      list.cells.push_back(cell);
    }
  return list;
}

/// Smallest damage on a facet, 0 where it is no fracture surface.
double facet_damage(const AdaptiveState& state, const FrontCell& cell, int facet, int dimension) {
  const std::int32_t a = cell.vertex[facet == 0 ? 1 : 0];
  const std::int32_t b = dimension == 1 ? a : cell.vertex[facet == 2 ? 1 : 2];
  const std::int32_t edge = state.front.crack_edge(a, b);
  return edge == none ? 0 : smallest_damage(state.crack_state[edge]);
}

std::vector<CellConnection> connections(const AdaptiveState& state, const CellList& list) {
  const FrontMesh& mesh = state.front.mesh();
  std::vector<CellConnection> result;
  for (const std::int32_t cell : list.cells)
    for (int facet = 0; facet <= mesh.dimension(); ++facet) {
      const std::int32_t neighbor = mesh.cell(cell).neighbor[facet];
      if (neighbor > cell)
        result.push_back(
            {list.index[cell], list.index[neighbor], facet_damage(state, mesh.cell(cell), facet, mesh.dimension())});
    }
  return result;
}

double edge_length(const AdaptiveState& state, int edge) {
  const auto& ends = state.front.cracks().edge(edge);
  if (ends[0] == ends[1]) return 1;
  return distance(state.front.mesh().position(ends[0]), state.front.mesh().position(ends[1])) *
         state.books.simulation.scaling.length;
}

/// Mean velocity of an element on its front facet (scaled): the mean over the cell of du/dt of its polynomial.
Point mean_velocity(const AdaptiveState& state, const ReferenceTablesView& tables, std::int32_t cell,
                    const double* coefficients, const double* inverse_jacobian) {
  const int d = tables.dimension + 1;
  // psi_0 = 1: the first mode of a derivative is its mean.
  const double* derivative = tables.facet_derivative(state.sources.facet[cell]);
  Point velocity{};
  for (int i = 0; i < tables.dimension; ++i)
    for (int l = 0; l < d; ++l)
      for (int a = 0; a < tables.num_basis; ++a)
        velocity[i] += inverse_jacobian[l * d + tables.dimension] * coefficients[i * tables.num_basis + a] *
                       derivative[(static_cast<long>(l) * tables.num_basis + a) * tables.facet_stride];
  return velocity;
}

}  // namespace

FrontState front_state(const AdaptiveState& state) {
  const FrontMesh& mesh = state.front.mesh();
  FrontState result;
  result.cells = mesh.num_cells();
  const CellList list = cells_in_use(mesh);
  double smallest = std::numeric_limits<double>::infinity();
  for (const std::int32_t cell : list.cells) {
    const auto vertices = mesh.vertices(cell);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        smallest = std::min(smallest, distance(mesh.position(vertices[i]), mesh.position(vertices[j])));
  }
  result.smallest_cell = smallest * state.books.simulation.scaling.length;
  result.fragments = 1;
  if (state.front.cracks().size() > 0) {
    const std::vector<CellContent> contents(list.cells.size());
    result.fragments = static_cast<std::int64_t>(find_fragments(contents, connections(state, list)).fragments.size());
  }
  return result;
}

SurfaceState surface_state(const AdaptiveState& state) {
  SurfaceState result;
  double weighted = 0;
  for (int edge = 0; edge < state.front.cracks().size(); ++edge) {
    if (state.front.cracks().is_retired(edge)) continue;
    const CrackEdgeState& crack = state.crack_state[edge];
    const double measure = edge_length(state, edge);
    result.surface_length += measure;
    weighted += measure * mean_damage(crack);
    result.crack_length += measure * failed_fraction(crack);
    result.damage_max = std::max(result.damage_max, largest_damage(crack));
  }
  result.damage_mean = result.surface_length > 0 ? weighted / result.surface_length : 0;
  return result;
}

std::vector<RunSummary::Fragment> fragments_in_motion(AdaptiveState& state) {
  const FrontMesh& mesh = state.front.mesh();
  const Simulation& simulation = state.books.simulation;
  const CellList list = cells_in_use(mesh);
  const ReferenceTables tables(mesh.dimension(), simulation.degree());
  const double volume_unit = std::pow(simulation.scaling.length, mesh.dimension());
  std::vector<CellContent> contents;
  for (const std::int32_t cell : list.cells) {
    CellContent content{};
    content.volume = std::fabs(signed_measure(mesh.simplex(cell))) * volume_unit;
    content.mass = simulation.materials[mesh.cell(cell).region].density * content.volume;
    contents.push_back(content);
  }
  constexpr std::size_t cells_per_transfer = 1 << 14;
  std::vector<double> coefficients, inverse_jacobians;
  for (std::size_t first = 0; first < list.cells.size(); first += cells_per_transfer) {
    std::vector<std::int32_t> slots;
    std::vector<std::size_t> owners;
    for (std::size_t i = first; i < std::min(first + cells_per_transfer, list.cells.size()); ++i)
      if (state.sources.slot[list.cells[i]] != none) {
        slots.push_back(state.sources.slot[list.cells[i]]);
        owners.push_back(i);
      }
    if (slots.empty()) continue;
    state.books.runner.read_slots(slots, coefficients, inverse_jacobians);
    const std::size_t n = coefficients.size() / slots.size(), d2 = inverse_jacobians.size() / slots.size();
    for (std::size_t s = 0; s < slots.size(); ++s) {
      CellContent& content = contents[owners[s]];
      const Point velocity =
          mean_velocity(state, tables.view(), list.cells[owners[s]], &coefficients[s * n], &inverse_jacobians[s * d2]);
      for (int axis = 0; axis < mesh.dimension(); ++axis)
        content.momentum[axis] = content.mass * velocity[axis] * simulation.scaling.speed;
    }
  }
  std::vector<RunSummary::Fragment> result;
  for (const Fragment& fragment : find_fragments(contents, connections(state, list)).fragments)
    result.push_back({fragment.content.volume, fragment.content.mass, fragment.velocity()});
  return result;
}

}  // namespace tentpole
