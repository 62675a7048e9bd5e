#include "host/mesh/mesh_facets.hpp"

#include <algorithm>
#include <limits>

#include "host/mesh/insertion_sort.hpp"
#include "host/mesh/simplex_geometry.hpp"
#include "host/mesh/toml_name.hpp"

namespace tentpole {

namespace {

std::vector<FacetOfCell> sorted_facets(const MeshDescription& description) {
  std::vector<FacetOfCell> all;
  all.reserve(description.cells.size() * (description.dimension + 1));
  for (std::size_t cell = 0; cell < description.cells.size(); ++cell)
    for (int facet = 0; facet <= description.dimension; ++facet)
      all.push_back({facet_vertices(description.dimension, description.cells[cell], facet),
                     static_cast<std::int32_t>(cell), facet});
  std::sort(all.begin(), all.end());
  return all;
}

/// Which side of the facet the opposite corner lies on: the sign of the measure with the facet's corners first.
double side_of_facet(const MeshDescription& description, const FacetVertices& facet, int opposite_vertex) {
  std::array<Point, SpaceMesh::max_corners> corners{};
  for (int i = 0; i < description.dimension; ++i) corners[i] = description.vertices[facet[i]];
  corners[description.dimension] = description.vertices[opposite_vertex];
  return signed_simplex_measure(description.dimension, corners);
}

/// Whether a point lies on a line segment or triangle: its distances to the ends (the areas with the edges) then add up
/// to the length (the area). The relative tolerance 1e-9 admits points about 1e-5 of the length beside a segment.
bool lies_on_facet(const MeshDescription& description, const FacetVertices& facet, const Point& point) {
  if (description.dimension == 1) return false;
  const auto& vertices = description.vertices;
  const Point &a = vertices[facet[0]], &b = vertices[facet[1]];
  if (description.dimension == 2) {
    const double length = distance(a, b);
    return distance(a, point) + distance(point, b) <= length * (1 + 1e-9);
  }
  const Point& c = vertices[facet[2]];
  const auto area = [](const Point& p, const Point& q, const Point& r) {
    return distance(cross(difference(q, p), difference(r, p)), Point{}) / 2;
  };
  return area(a, b, point) + area(b, c, point) + area(c, a, point) <= area(a, b, c) * (1 + 1e-9);
}

/// Which names count before others where a facet has several.
std::vector<bool> used_boundaries(const MeshDescription& description) {
  std::vector<bool> is_used;
  for (const std::string& name : description.boundary_names)
    is_used.push_back(!description.use || description.use->has_boundary(name));
  return is_used;
}

[[noreturn]] void throw_two_boundaries(const MeshDescription& description, const FacetVertices& facet, int boundary,
                                       int other) {
  const std::string &first = description.boundary_names[boundary], &second = description.boundary_names[other];
  throw MeshError(description.source, description.facet_label(facet),
                  "belongs to two boundaries, " + first + " and " + second +
                      (description.use ? ", and both have a condition. Keep one of [boundary." + toml_key(first) +
                                             "] and [boundary." + toml_key(second) + "], or make the groups disjoint."
                                       : ". Keep one physical group."));
}

/// Where a named facet lies: the cell that has it, or none.
struct FacetPlace {
  std::int32_t cell = none;
  std::int32_t facet = none;
  bool is_inside = false;  ///< between two cells
};

FacetPlace find_facet(const FacetTable& facets, const FacetVertices& vertices) {
  const auto found = std::lower_bound(facets.sorted.begin(), facets.sorted.end(), FacetOfCell{vertices, 0, 0});
  if (found == facets.sorted.end() || found->vertices != vertices) return {};
  return {found->cell, found->facet, facets.neighbor[found->cell][found->facet] != none};
}

void check_crack_is_inside(const MeshDescription& description, const NamedFacet& crack, const FacetPlace& place) {
  if (place.is_inside) return;
  throw MeshError(description.source, description.facet_label(crack.vertices),
                  "belongs to the crack " + description.boundary_names[crack.boundary] +
                      (place.cell == none
                           ? ", but to no cell. Fit the mesh to the crack (in Gmsh: embed its curve in the surface)."
                           : ", but lies on the boundary of the body, where there is nothing to separate from. Name a "
                             "side inside the body in [[fracture.crack]], or give points."));
}

}  // namespace

FacetVertices facet_vertices(int dimension, const CellVertices& cell, int facet) {
  FacetVertices vertices{none, none, none};
  for (int corner = 0, i = 0; corner <= dimension; ++corner)
    if (corner != facet) vertices[i++] = cell[corner];
  return vertices;
}

FacetTable match_facets(const MeshDescription& description) {
  const std::size_t num_cells = description.cells.size();
  const CellVertices absent{none, none, none, none};
  FacetTable table;
  table.neighbor.assign(num_cells, absent);
  table.neighbor_facet.resize(num_cells);
  table.boundary.assign(num_cells, absent);
  table.sorted = sorted_facets(description);
  const std::vector<FacetOfCell>& all = table.sorted;
  for (std::size_t first = 0; first < all.size();) {
    std::size_t end = first + 1;
    while (end < all.size() && all[end].vertices == all[first].vertices) ++end;
    const FacetOfCell &a = all[first], &b = all[end - 1];
    if (end - first > 2)
      throw MeshError(description.source, description.facet_label(a.vertices),
                      std::to_string(end - first) + " cells meet here (" + description.cell_label(a.cell) + ", " +
                          description.cell_label(all[first + 1].cell) + ", " + description.cell_label(b.cell) +
                          (end - first > 3 ? ", ..." : "") + "); at most two may. Remove the surplus cells.");
    if (end - first == 2) {
      table.neighbor[a.cell][a.facet] = b.cell;
      table.neighbor[b.cell][b.facet] = a.cell;
      table.neighbor_facet[a.cell][a.facet] = static_cast<std::uint8_t>(b.facet);
      table.neighbor_facet[b.cell][b.facet] = static_cast<std::uint8_t>(a.facet);
    }
    first = end;
  }
  return table;
}

void check_cells_do_not_overlap(const MeshDescription& description, const FacetTable& facets) {
  for (std::size_t cell = 0; cell < description.cells.size(); ++cell)
    for (int facet = 0; facet <= description.dimension; ++facet) {
      const std::int32_t other = facets.neighbor[cell][facet];
      if (other <= static_cast<std::int32_t>(cell)) continue;
      const FacetVertices vertices = facet_vertices(description.dimension, description.cells[cell], facet);
      const double own_side = side_of_facet(description, vertices, description.cells[cell][facet]);
      const double other_side =
          side_of_facet(description, vertices, description.cells[other][facets.neighbor_facet[cell][facet]]);
      if ((own_side > 0) == (other_side > 0))
        throw MeshError(description.source,
                        description.cell_label(static_cast<int>(cell)) + " and " + description.cell_label(other),
                        "both lie on the same side of their common " + description.facet_label(vertices) +
                            ", so one of them is inverted. " +
                            description.way_out("Repair the mesh (in Gmsh: Optimize, or refine there)."));
    }
}

void name_facets(const MeshDescription& description, FacetTable& facets, std::vector<std::string>& warnings) {
  const std::vector<bool> is_used = used_boundaries(description);
  int num_ignored = 0;
  std::string example;
  for (const NamedFacet& named : description.named_facets) {
    FacetVertices vertices = named.vertices;
    insertion_sort(vertices, description.dimension);
    const FacetPlace place = find_facet(facets, vertices);
    if (description.is_crack(named.boundary)) check_crack_is_inside(description, {vertices, named.boundary}, place);
    if (place.is_inside) facets.inner.push_back({vertices, named.boundary});
    if (place.cell == none || place.is_inside) {
      if (!description.is_crack(named.boundary) && num_ignored++ == 0)
        example = description.facet_label(vertices) + " of " + description.boundary_names[named.boundary];
      continue;
    }
    std::int32_t& boundary = facets.boundary[place.cell][place.facet];
    if (boundary != none && boundary != named.boundary && is_used[boundary] && is_used[named.boundary])
      throw_two_boundaries(description, vertices, boundary, named.boundary);
    if (boundary == none || is_used[named.boundary]) boundary = named.boundary;
  }
  if (num_ignored > 0)
    warnings.push_back(description.source + ": " + std::to_string(num_ignored) +
                       " named facets do not lie on the boundary and are ignored, " + example + " first.");
}

void check_boundary_is_named(const MeshDescription& description, const FacetTable& facets) {
  std::vector<FacetVertices> nameless;
  for (std::size_t cell = 0; cell < description.cells.size(); ++cell)
    for (int facet = 0; facet <= description.dimension; ++facet)
      if (facets.neighbor[cell][facet] == none && facets.boundary[cell][facet] == none)
        nameless.push_back(facet_vertices(description.dimension, description.cells[cell], facet));
  if (nameless.empty()) return;
  std::vector<std::int32_t> candidates;
  for (const FacetVertices& facet : nameless)
    candidates.insert(candidates.end(), facet.begin(), facet.begin() + description.dimension);
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  // A facet with a hanging node has nameless facets on both sides, so its vertices are all among the candidates. The
  // search is quadratic; a thousand facets are more than enough to find one.
  const std::size_t num_searched = std::min<std::size_t>(nameless.size(), 1000);
  for (std::size_t i = 0; i < num_searched; ++i)
    for (const std::int32_t vertex : candidates) {
      const FacetVertices& facet = nameless[i];
      if (std::find(facet.begin(), facet.end(), vertex) == facet.end() &&
          lies_on_facet(description, facet, description.vertices[vertex]))
        throw MeshError(description.source, description.vertex_label(vertex),
                        "is a hanging node: it lies on " + description.facet_label(facet) +
                            " but is no corner of the cell there. Make the mesh conforming.");
    }
  throw MeshError(description.source, description.facet_label(nameless.front()),
                  "lies on the boundary but has no name (" + std::to_string(nameless.size()) +
                      " such facets). Put it into a physical group of dimension " +
                      std::to_string(description.dimension - 1) + ".");
}

}  // namespace tentpole
