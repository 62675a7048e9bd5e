#include <algorithm>
#include <stdexcept>

#include "host/front/front_mesh.hpp"

namespace tentpole {

/// A facet that waits for the cell on its other side while cells are replaced.
struct FrontMesh::OpenFacet {
  std::array<std::int32_t, 2> vertex;  ///< ascending
  std::int32_t cell;                   ///< or none: the outside of the domain
  std::int32_t boundary;               ///< where cell is none
  std::uint8_t facet;
};

namespace {

std::array<std::int32_t, 2> facet_vertices(int dimension, const FrontVertices& vertex, int facet) {
  if (dimension == 1) return {none, vertex[1 - facet]};
  return {vertex[facet == 0 ? 1 : 0], vertex[facet == 2 ? 1 : 2]};
}

}  // namespace

std::int32_t FrontMesh::add_vertex(const Point& position, double time, VertexKind kind) {
  if (free_vertices_.empty()) {
    position_.push_back(position);
    time_.push_back(time);
    kind_.push_back(kind);
    star_.emplace_back();
    return num_vertex_slots() - 1;
  }
  const std::int32_t vertex = free_vertices_.back();
  free_vertices_.pop_back();
  position_[vertex] = position;
  time_[vertex] = time;
  kind_[vertex] = kind;
  return vertex;
}

std::int32_t FrontMesh::add_cell(const NewFrontCell& cell) {
  std::int32_t id = num_cell_slots();
  if (free_cells_.empty()) {
    cells_.emplace_back();
  } else {
    id = free_cells_.back();
    free_cells_.pop_back();
  }
  cells_[id] = {cell.vertex, {none, none, none},     {none, none, none}, cell.region, cell.generation,
                {},          cell.refinement_corner, next_serial_++};
  for (int corner = 0; corner < num_corners(); ++corner) {
    auto& star = star_[cell.vertex[corner]];
    const auto place = std::find_if(star.begin(), star.end(), [&](const CellCorner& entry) { return entry.cell > id; });
    star.insert(place, {id, corner});
  }
  return id;
}

void FrontMesh::remove_cell(int cell) {
  for (const std::int32_t vertex : vertices(cell)) {
    auto& star = star_[vertex];
    star.erase(std::find_if(star.begin(), star.end(), [&](const CellCorner& entry) { return entry.cell == cell; }));
  }
  cells_[cell].serial = none;
  free_cells_.push_back(cell);
}

void FrontMesh::link(std::int32_t id, std::vector<OpenFacet>& open) {
  FrontCell& cell = cells_[id];
  for (int facet = 0; facet < num_corners(); ++facet) {
    const auto vertex = facet_vertices(dimension_, cell.vertex, facet);
    const auto other = std::find_if(open.begin(), open.end(), [&](const OpenFacet& o) { return o.vertex == vertex; });
    if (other == open.end()) {
      open.push_back({vertex, id, none, static_cast<std::uint8_t>(facet)});
      continue;
    }
    cell.neighbor[facet] = other->cell;
    cell.boundary[facet] = other->boundary;
    cell.neighbor_facet[facet] = other->facet;
    if (other->cell != none) {
      cells_[other->cell].neighbor[other->facet] = id;
      cells_[other->cell].neighbor_facet[other->facet] = static_cast<std::uint8_t>(facet);
    }
    open.erase(other);
  }
}

std::vector<std::int32_t> FrontMesh::replace(std::span<const std::int32_t> removed, std::span<const NewFrontCell> added,
                                             std::span<const NewBoundaryFacet> boundary) {
  std::vector<OpenFacet> open;
  std::vector<std::int32_t> touched;
  for (const std::int32_t id : removed) {
    touched.insert(touched.end(), vertices(id).begin(), vertices(id).end());
    for (int facet = 0; facet < num_corners(); ++facet) {
      const FrontCell& cell = cells_[id];
      const std::int32_t other = cell.neighbor[facet];
      if (std::find(removed.begin(), removed.end(), other) != removed.end()) continue;
      open.push_back(
          {facet_vertices(dimension_, cell.vertex, facet), other, cell.boundary[facet], cell.neighbor_facet[facet]});
    }
  }
  for (const NewBoundaryFacet& facet : boundary)
    open.push_back({{std::min(facet.vertex[0], facet.vertex[1]), std::max(facet.vertex[0], facet.vertex[1])},
                    none,
                    facet.boundary,
                    0});
  for (const std::int32_t id : removed) remove_cell(id);
  std::vector<std::int32_t> ids;
  for (const NewFrontCell& cell : added) {
    ids.push_back(add_cell(cell));
    link(ids.back(), open);
  }
  // What is left may only be a boundary facet that was cut or merged.
  if (std::any_of(open.begin(), open.end(), [](const OpenFacet& facet) { return facet.cell != none; }))
    throw std::logic_error("new front cells do not fit the place of those they replace");
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  for (const std::int32_t vertex : touched)
    if (star_[vertex].empty()) free_vertices_.push_back(vertex);
  return ids;
}

}  // namespace tentpole
