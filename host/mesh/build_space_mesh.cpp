#include <algorithm>
#include <numeric>

#include "host/mesh/doubled_sides.hpp"
#include "host/mesh/insertion_sort.hpp"
#include "host/mesh/mesh_checks.hpp"
#include "host/mesh/mesh_description.hpp"
#include "host/mesh/mesh_facets.hpp"
#include "host/mesh/periodic_sides.hpp"

namespace tentpole {

namespace {

/// New vertex ids: representatives only, in the order of the description.
std::vector<std::int32_t> number_representatives(const std::vector<std::int32_t>& representative) {
  std::vector<std::int32_t> id(representative.size(), none);
  std::int32_t num_vertices = 0;
  for (std::size_t vertex = 0; vertex < id.size(); ++vertex)
    id[vertex] =
        representative[vertex] == static_cast<std::int32_t>(vertex) ? num_vertices++ : id[representative[vertex]];
  return id;
}

/// order[i]: which corner of the description becomes corner i, so that vertex ids ascend; identity beyond the
/// dimension.
using CornerOrder = std::array<std::uint8_t, SpaceMesh::max_corners>;

CornerOrder ascending_corners(const MeshDescription& description, const CellVertices& cell,
                              const std::vector<std::int32_t>& id) {
  CornerOrder order{0, 1, 2, 3};
  insertion_sort(order, description.dimension + 1, [&](int a, int b) { return id[cell[a]] < id[cell[b]]; });
  return order;
}

CornerOrder inverse(const CornerOrder& order) {
  CornerOrder result{};
  for (std::uint8_t i = 0; i < order.size(); ++i) result[order[i]] = i;
  return result;
}

void fill_cells(const MeshDescription& description, const FacetTable& facets, const PeriodicVertices& periodic,
                SpaceMesh& mesh) {
  const std::vector<std::int32_t> id = number_representatives(periodic.representative);
  const std::size_t num_cells = description.cells.size();
  std::vector<CornerOrder> orders(num_cells);
  for (std::size_t cell = 0; cell < num_cells; ++cell)
    orders[cell] = ascending_corners(description, description.cells[cell], id);
  const CellVertices absent{none, none, none, none};
  mesh.cells.assign(num_cells, absent);
  mesh.neighbor.assign(num_cells, absent);
  mesh.facet_boundary.assign(num_cells, absent);
  mesh.corner_shift.assign(num_cells, {});
  mesh.neighbor_facet.assign(num_cells, {});
  for (std::size_t cell = 0; cell < num_cells; ++cell)
    for (int i = 0; i <= description.dimension; ++i) {
      const int old = orders[cell][i];
      const std::int32_t vertex = description.cells[cell][old], neighbor = facets.neighbor[cell][old];
      mesh.cells[cell][i] = id[vertex];
      mesh.corner_shift[cell][i] = periodic.shift[vertex];
      mesh.neighbor[cell][i] = neighbor;
      mesh.facet_boundary[cell][i] = facets.boundary[cell][old];
      if (neighbor != none) mesh.neighbor_facet[cell][i] = inverse(orders[neighbor])[facets.neighbor_facet[cell][old]];
    }
  for (std::size_t vertex = 0; vertex < id.size(); ++vertex)
    if (periodic.representative[vertex] == static_cast<std::int32_t>(vertex))
      mesh.vertices.push_back(description.vertices[vertex]);
}

void fill_inner_sides(const MeshDescription& description, const FacetTable& facets, const PeriodicVertices& periodic,
                      SpaceMesh& mesh) {
  const std::vector<std::int32_t> id = number_representatives(periodic.representative);
  std::vector<InnerSide> sides(description.boundary_names.size());
  for (const NamedFacet& named : facets.inner) {
    FacetVertices facet = named.vertices;
    for (int i = 0; i < description.dimension; ++i) facet[i] = id[facet[i]];
    insertion_sort(facet, description.dimension);
    sides[named.boundary].facets.push_back(facet);
  }
  for (std::size_t boundary = 0; boundary < sides.size(); ++boundary) {
    InnerSide& side = sides[boundary];
    if (side.facets.empty()) continue;
    side.name = description.boundary_names[boundary];
    std::sort(side.facets.begin(), side.facets.end());
    side.facets.erase(std::unique(side.facets.begin(), side.facets.end()), side.facets.end());
    mesh.inner_sides.push_back(std::move(side));
  }
}

/// Renumbers the boundaries so that only those with facets remain.
void keep_boundaries_with_facets(SpaceMesh& mesh) {
  std::vector<std::int32_t> new_index(mesh.boundary_names.size(), none);
  for (const auto& boundaries : mesh.facet_boundary)
    for (const std::int32_t boundary : boundaries)
      if (boundary != none) new_index[boundary] = 0;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < new_index.size(); ++i) {
    if (new_index[i] == none) continue;
    new_index[i] = static_cast<std::int32_t>(names.size());
    names.push_back(mesh.boundary_names[i]);
  }
  mesh.boundary_names = names;
  for (auto& boundaries : mesh.facet_boundary)
    for (std::int32_t& boundary : boundaries)
      if (boundary != none) boundary = new_index[boundary];
}

void fill_stars(SpaceMesh& mesh) {
  mesh.star_offset.assign(mesh.vertices.size() + 1, 0);
  for (const auto& cell : mesh.cells)
    for (int corner = 0; corner <= mesh.dimension; ++corner) ++mesh.star_offset[cell[corner] + 1];
  std::partial_sum(mesh.star_offset.begin(), mesh.star_offset.end(), mesh.star_offset.begin());
  mesh.star_entries.resize(mesh.star_offset.back());
  std::vector<std::int32_t> next(mesh.star_offset.begin(), mesh.star_offset.end() - 1);
  for (std::int32_t cell = 0; cell < mesh.num_cells(); ++cell)
    for (std::int32_t corner = 0; corner <= mesh.dimension; ++corner)
      mesh.star_entries[next[mesh.cells[cell][corner]]++] = {cell, corner};
}

}  // namespace

SpaceMesh build_space_mesh(MeshDescription description, const PeriodicPairs& periodic) {
  SpaceMesh mesh;
  drop_unused_vertices(description, mesh.warnings);
  check_coordinates(description);
  merge_doubled_cracks(description);
  check_places(description);
  check_cells(description);
  for (CellVertices& cell : description.cells) insertion_sort(cell, description.dimension + 1);
  FacetTable facets = match_facets(description);
  check_cells_do_not_overlap(description, facets);
  name_facets(description, facets, mesh.warnings);
  check_boundary_is_named(description, facets);
  const PeriodicVertices identified = identify_periodic_sides(description, periodic, facets);
  mesh.dimension = description.dimension;
  mesh.cell_region = description.cell_region;
  mesh.region_names = description.region_names;
  mesh.boundary_names = description.boundary_names;
  mesh.shifts = identified.shifts;
  fill_cells(description, facets, identified, mesh);
  fill_inner_sides(description, facets, identified, mesh);
  keep_boundaries_with_facets(mesh);
  fill_stars(mesh);
  return mesh;
}

}  // namespace tentpole
