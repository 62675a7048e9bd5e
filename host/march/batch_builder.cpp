#include "host/march/batch_builder.hpp"

#include <algorithm>

namespace tentpole {

BatchBuilder::BatchBuilder(const Simulation& simulation, Front& front, CellSources& sources, ElementStore& store)
    : simulation_(simulation),
      front_(front),
      sources_(sources),
      store_(store),
      prescribed_(simulation),
      element_of_cell_(simulation.mesh.num_cells(), none) {}

void BatchBuilder::build(HostBatch& batch, int max_patches) {
  batch.clear();
  const double end_time = simulation_.scaled_end_time();
  for (const int vertex : front_.next_minima(max_patches, end_time))
    add_tent(batch, vertex, front_.pole_top_time(vertex, end_time));
  store_.end_batch();
  batch.num_slots = store_.num_slots();
  batch.front_minimum_time = front_.minimum_time();
}

void BatchBuilder::add_tent(HostBatch& batch, int vertex, double top_time) {
  const auto star = front_.star(vertex);
  const int first_element = static_cast<int>(batch.elements.size());
  for (std::size_t i = 0; i < star.size(); ++i) element_of_cell_[star[i].cell] = first_element + static_cast<int>(i);
  for (const CellCorner& pole : star) describe_cell(batch, pole, top_time);
  batch.patches.push_back({first_element, static_cast<std::int32_t>(star.size())});
  front_.raise(vertex, top_time);
}

void BatchBuilder::describe_cell(HostBatch& batch, const CellCorner& pole, double top_time) {
  const SpaceMesh& mesh = simulation_.mesh;
  const int dimension = mesh.dimension, cell = pole.cell;
  ElementDescriptor element{};
  for (int corner = 0; corner <= dimension; ++corner) {
    const Point position = mesh.corner_position(cell, corner);
    for (int axis = 0; axis < dimension; ++axis) element.corner[corner][axis] = position[axis];
    element.corner[corner][dimension] = front_.time(mesh.cells[cell][corner]);
  }
  std::copy_n(element.corner[pole.corner], dimension, element.corner[dimension + 1]);
  element.corner[dimension + 1][dimension] = top_time;
  element.pole = pole.corner;
  element.material = mesh.cell_region[cell];
  describe_inflow(batch, element, cell);
  element.result_slot = store_.acquire();
  element.body_force_data = prescribed_.add_body_force(element, batch.prescribed);
  describe_facets(batch, element, cell);
  sources_.slot[cell] = element.result_slot;
  sources_.facet[cell] = facet_table(element, dimension, element.pole);
  batch.elements.push_back(element);
  batch.cells.push_back(cell);
}

void BatchBuilder::describe_inflow(HostBatch& batch, ElementDescriptor& element, int cell) {
  const int facet = simulation_.mesh.dimension + 1;
  element.facet_kind[facet] = FacetKind::inflow;
  element.neighbor[facet] = element.facet_data[facet] = none;
  element.source_slot[facet] = sources_.slot[cell];
  element.source_facet[facet] = static_cast<std::uint8_t>(sources_.facet[cell]);
  if (element.source_slot[facet] == none) {
    element.facet_data[facet] = prescribed_.add_initial(element, facet, batch.prescribed);
  } else {
    store_.release(element.source_slot[facet]);
  }
}

void BatchBuilder::describe_facets(HostBatch& batch, ElementDescriptor& element, int cell) {
  const SpaceMesh& mesh = simulation_.mesh;
  for (int facet = 0; facet <= mesh.dimension; ++facet) {
    element.facet_kind[facet] = FacetKind::outflow;
    element.neighbor[facet] = element.source_slot[facet] = element.facet_data[facet] = none;
    if (facet == element.pole) continue;
    const std::int32_t neighbor = mesh.neighbor[cell][facet];
    if (neighbor != none) {
      element.facet_kind[facet] = FacetKind::interior;
      element.neighbor[facet] = element_of_cell_[neighbor];
      element.neighbor_facet[facet] = mesh.neighbor_facet[cell][facet];
      continue;
    }
    element.facet_kind[facet] = FacetKind::boundary;
    const int boundary = mesh.facet_boundary[cell][facet];
    element.normal_kind[facet] = simulation_.conditions[boundary].normal_kind();
    element.tangential_kind[facet] = simulation_.conditions[boundary].tangential_kind();
    element.facet_data[facet] = prescribed_.add_boundary(element, facet, boundary, batch.prescribed);
  }
}

}  // namespace tentpole
