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

/// Vertices of a general element, ascending, of a new cell and one vertex more.
std::vector<std::int32_t> element_vertices(const FrontVertices& cell, int num_corners, std::int32_t vertex) {
  std::vector<std::int32_t> vertices(cell.begin(), cell.begin() + num_corners);
  vertices.push_back(vertex);
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

/// The same without one of them: a facet.
std::vector<std::int32_t> without(std::vector<std::int32_t> vertices, int corner) {
  vertices.erase(vertices.begin() + corner);
  return vertices;
}

}  // namespace

void PatchWriter::write(const PatchPlan& plan, HostBatch& batch) {
  const int first_element = static_cast<int>(batch.elements.size());
  const int first_fracture = static_cast<int>(batch.fractures.size());
  switch (plan.operation) {
    case PatchOperation::deletion:
      write_cone(*plan.deletion, batch);
      break;
    case PatchOperation::flip:
      write_flip(*plan.flip, batch);
      break;
    default:
      write_tent(plan, batch);
  }
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
  for (const FootprintCell& below : plan.footprint) {
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
    const auto place = std::ranges::find(plan.footprint, other, &FootprintCell::cell);
    return static_cast<std::int32_t>(place - plan.footprint.begin());
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

/// One element per new cell: it is the outflow facet; of the other facets those on old cells are inflow, those between
/// new cells interior, and the merged boundary facet takes the condition of its side.
void PatchWriter::write_cone(const DeletionPlan& plan, HostBatch& batch) {
  const FrontMesh& mesh = state_.front.mesh();
  const int dimension = mesh.dimension();
  const std::int32_t first = static_cast<std::int32_t>(batch.elements.size());
  std::vector<std::vector<std::int32_t>> vertices;
  for (const NewFrontCell& cell : plan.cells)
    vertices.push_back(element_vertices(cell.vertex, dimension + 1, plan.vertex));
  for (std::size_t e = 0; e < plan.cells.size(); ++e) {
    ElementDescriptor element = empty_element();
    element.material = plan.cells[e].region;
    for (int corner = 0; corner <= dimension + 1; ++corner)
      put_corner(element, corner, mesh.position(vertices[e][corner]), mesh.time(vertices[e][corner]));
    std::int32_t cell_below = plan.footprint.front().cell;
    for (int facet = 0; facet <= dimension + 1; ++facet) {
      if (vertices[e][facet] == plan.vertex) continue;
      const std::vector<std::int32_t> corners = without(vertices[e], facet);
      const auto below = std::ranges::find_if(plan.footprint, [&](const FootprintCell& cell) {
        return std::ranges::equal(mesh.vertices(cell.cell), corners);
      });
      if (below != plan.footprint.end()) {
        write_inflow(batch, element, facet, below->cell);
        cell_below = below->cell;
        continue;
      }
      for (std::size_t other = 0; other < plan.cells.size(); ++other)
        for (int across = 0; across <= dimension + 1; ++across)
          if (other != e && without(vertices[other], across) == corners) {
            element.facet_kind[facet] = FacetKind::interior;
            element.neighbor[facet] = first + static_cast<std::int32_t>(other);
            element.neighbor_facet[facet] = static_cast<std::uint8_t>(across);
          }
      if (element.facet_kind[facet] != FacetKind::interior)
        write_boundary(batch, element, facet, plan.boundary.front().boundary);
    }
    finish(batch, element, cell_below);
  }
}

/// One element with two old cells below and two new ones above.
void PatchWriter::write_flip(const FlipPlan& plan, HostBatch& batch) {
  const FrontMesh& mesh = state_.front.mesh();
  std::vector<std::int32_t> vertices(plan.edge.begin(), plan.edge.end());
  vertices.insert(vertices.end(), plan.diagonal.begin(), plan.diagonal.end());
  std::sort(vertices.begin(), vertices.end());
  ElementDescriptor element = empty_element();
  for (int corner = 0; corner < 4; ++corner)
    put_corner(element, corner, mesh.position(vertices[corner]), mesh.time(vertices[corner]));
  for (const FootprintCell& below : plan.footprint)
    for (int facet = 0; facet < 4; ++facet)
      if (std::ranges::equal(mesh.vertices(below.cell), without(vertices, facet)))
        write_inflow(batch, element, facet, below.cell);
  finish(batch, element, plan.footprint.front().cell);
}

}  // namespace tentpole
