#include "host/march/patch_writer.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace tentpole {
namespace {

/// Largest damage on the crack edges of a front cell.
double largest_damage_at(const AdaptiveState& state, std::int32_t cell) {
  const auto vertices = state.front.mesh().vertices(cell);
  double largest = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t j = vertices.size() == 2 ? i : i + 1; j < vertices.size(); ++j)
      if (const std::int32_t edge = state.front.crack_edge(vertices[i], vertices[j]); edge != none)
        largest = std::max(largest, largest_damage(state.crack_state[edge]));
  return largest;
}

/// An element without facets yet.
ElementDescriptor empty_element() {
  ElementDescriptor element{};
  element.pole = none;
  for (int facet = 0; facet < ElementDescriptor::max_facets; ++facet) {
    element.facet_kind[facet] = FacetKind::outflow;
    element.neighbor[facet] = element.source_slot[facet] = element.facet_data[facet] = none;
  }
  return element;
}

/// Facet of an element of an exchange: its vertices but one, ascending.
using FacetVertices = std::array<std::int32_t, FrontSimplex::max_corners>;

FacetVertices facet_vertices(const SpacetimeSimplex& element, int facet) {
  FacetVertices vertices{};
  std::remove_copy(element.vertex.begin(), element.vertex.end(), vertices.begin(), element.vertex[facet]);
  return vertices;
}

}  // namespace

void PatchWriter::write(const PatchPlan& plan, HostBatch& batch) {
  const int first_element = static_cast<int>(batch.elements.size());
  const int first_fracture = static_cast<int>(batch.fractures.size());
  if (plan.is_tent())
    write_tent(plan, batch);
  else
    write_exchange(plan.exchange, batch);
  PatchDescriptor patch;
  patch.first_element = first_element;
  patch.num_elements = static_cast<std::int32_t>(batch.elements.size()) - first_element;
  patch.is_general = plan.operation != PatchOperation::tent;
  patch.first_fracture = first_fracture;
  patch.num_fractures = static_cast<std::int32_t>(batch.fractures.size()) - first_fracture;
  batch.patches.push_back(patch);
}

void PatchWriter::put_corner(ElementDescriptor& element, int corner, const Point& position, double time) const {
  const int dimension = state_.front.mesh().dimension();
  std::copy_n(position.begin(), dimension, element.corner[corner]);
  element.corner[corner][dimension] = time;
}

/// `cell`: named in messages.
void PatchWriter::finish(HostBatch& batch, ElementDescriptor& element, std::int32_t cell) {
  element.result_slot = state_.books.store.acquire();
  element.body_force_data = prescribed_.add_body_force(element, batch.prescribed);
  batch.elements.push_back(element);
  batch.cells.push_back(cell);
  if (state_.has_fracture()) batch.damage.push_back(largest_damage_at(state_, cell));
}

void PatchWriter::write_inflow(HostBatch& batch, ElementDescriptor& element, int facet, std::int32_t cell) {
  element.facet_kind[facet] = FacetKind::inflow;
  element.source_slot[facet] = state_.sources.slot[cell];
  element.source_facet[facet] = static_cast<std::uint8_t>(state_.sources.facet[cell]);
  element.material = state_.front.mesh().cell(cell).region;
  if (element.source_slot[facet] == none)
    element.facet_data[facet] = prescribed_.add_initial(element, facet, batch.prescribed);
}

void PatchWriter::write_boundary(HostBatch& batch, ElementDescriptor& element, int facet, int boundary) {
  const BoundaryCondition& condition = state_.books.simulation.conditions[boundary];
  element.facet_kind[facet] = FacetKind::boundary;
  element.normal_kind[facet] = condition.normal_kind();
  element.tangential_kind[facet] = condition.tangential_kind();
  element.facet_data[facet] = prescribed_.add_boundary(element, facet, boundary, batch.prescribed);
}

void PatchWriter::write_tent(const PatchPlan& plan, HostBatch& batch) {
  const FrontMesh& mesh = state_.front.mesh();
  const int dimension = mesh.dimension();
  for (const FootprintCell& below : plan.below()) {
    ElementDescriptor element = empty_element();
    const auto vertices = mesh.vertices(below.cell);
    for (int corner = 0; corner <= dimension; ++corner) {
      put_corner(element, corner, mesh.position(vertices[corner]), mesh.time(vertices[corner]));
      if (vertices[corner] == plan.vertex) element.pole = corner;
    }
    put_corner(element, dimension + 1, plan.top.position, plan.top.time);
    write_inflow(batch, element, dimension + 1, below.cell);
    write_tent_facets(plan, batch, below.cell, element);
    finish(batch, element, below.cell);
  }
}

void PatchWriter::write_tent_facets(const PatchPlan& plan, HostBatch& batch, std::int32_t cell,
                                    ElementDescriptor& element) {
  const FrontMesh& mesh = state_.front.mesh();
  const FrontCell& front_cell = mesh.cell(cell);
  const int dimension = mesh.dimension();
  const auto index_of = [&](std::int32_t other) {
    const auto place = std::ranges::find(plan.below(), other, &FootprintCell::cell);
    return static_cast<std::int32_t>(place - plan.below().begin());
  };
  const std::int32_t own_index = index_of(cell), element_index = static_cast<std::int32_t>(batch.elements.size());
  for (int facet = 0; facet <= dimension; ++facet) {
    if (facet == element.pole) continue;
    if (front_cell.neighbor[facet] == none) {
      write_boundary(batch, element, facet, front_cell.boundary[facet]);
      continue;
    }
    element.neighbor[facet] = element_index - own_index + index_of(front_cell.neighbor[facet]);
    element.neighbor_facet[facet] = front_cell.neighbor_facet[facet];
    element.facet_kind[facet] = FacetKind::interior;
    const std::int32_t end = dimension == 1 ? plan.vertex : front_cell.vertex[3 - facet - element.pole];
    const std::int32_t crack_edge = state_.front.crack_edge(plan.vertex, end);
    if (crack_edge == none) continue;
    element.facet_kind[facet] = FacetKind::fracture;
    if (element.neighbor[facet] > element_index)
      write_fracture(batch, facet, element_index, element.neighbor[facet], element.neighbor_facet[facet], crack_edge,
                     plan.vertex);
  }
}

void PatchWriter::write_fracture(HostBatch& batch, int facet, std::int32_t element, std::int32_t neighbor,
                                 int neighbor_facet, std::int32_t crack_edge, std::int32_t vertex) {
  const CrackEdgeState& crack = state_.crack_state[crack_edge];
  FractureFacet fracture{};
  fracture.element[0] = element;
  fracture.element[1] = neighbor;
  fracture.facet[0] = static_cast<std::uint8_t>(facet);
  fracture.facet[1] = static_cast<std::uint8_t>(neighbor_facet);
  const auto& ends = state_.front.cracks().edge(crack_edge);
  fracture.rising_end = ends[0] != ends[1] && ends[1] == vertex ? 1 : 0;
  for (int point = 0; point < crack.num_points; ++point) {
    fracture.damage[point] = crack.damage[point];
    fracture.gap[point] = crack.gap[point];
  }
  batch.fractures.push_back(fracture);
  batch.crack_edges.push_back(crack_edge);
}

void PatchWriter::write_exchange(const CellExchange& exchange, HostBatch& batch) {
  const FrontMesh& mesh = state_.front.mesh();
  const std::size_t first = batch.elements.size();
  for (std::size_t number = 0; number < exchange.between.size(); ++number) {
    ElementDescriptor element = empty_element();
    element.material = exchange.between[number].region;
    for (int corner = 0; corner <= mesh.dimension() + 1; ++corner) {
      const std::int32_t vertex = exchange.between[number].vertex[corner];
      put_corner(element, corner, mesh.position(vertex), mesh.time(vertex));
    }
    const std::int32_t cell_below = write_exchange_facets(exchange, first, number, batch, element);
    finish(batch, element, cell_below);
  }
}

/// Facets are told by their vertices. Returns a cell that the element stands on, or else one below the patch.
std::int32_t PatchWriter::write_exchange_facets(const CellExchange& exchange, std::size_t first, std::size_t number,
                                                HostBatch& batch, ElementDescriptor& element) {
  std::int32_t cell_below = exchange.below.front().cell;
  const int num_facets = state_.front.mesh().dimension() + 2;
  for (int facet = 0; facet < num_facets; ++facet) {
    const FacetVertices vertices = facet_vertices(exchange.between[number], facet);
    if (std::ranges::find(exchange.above, vertices, &NewFrontCell::vertex) != exchange.above.end()) continue;
    const auto below = std::ranges::find_if(exchange.below, [&](const FootprintCell& entry) {
      return state_.front.mesh().cell(entry.cell).vertex == vertices;
    });
    if (below != exchange.below.end()) {
      cell_below = below->cell;
      write_inflow(batch, element, facet, cell_below);
      continue;
    }
    for (std::size_t other = 0; other < exchange.between.size(); ++other)
      for (int across = 0; other != number && across < num_facets; ++across)
        if (facet_vertices(exchange.between[other], across) == vertices) {
          element.facet_kind[facet] = FacetKind::interior;
          element.neighbor[facet] = static_cast<std::int32_t>(first + other);
          element.neighbor_facet[facet] = static_cast<std::uint8_t>(across);
        }
    if (element.facet_kind[facet] != FacetKind::interior)
      write_boundary(batch, element, facet, exchange.boundary.front().boundary);
  }
  return cell_below;
}

}  // namespace tentpole
