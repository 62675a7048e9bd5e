#include "host/mesh/doubled_sides.hpp"

#include <algorithm>

#include "host/mesh/insertion_sort.hpp"
#include "host/mesh/mesh_facets.hpp"
#include "host/mesh/point_finder.hpp"

namespace tentpole {

namespace {

/// [vertex] the smallest index of those at its place. Places chain: what is at the place of a neighbour counts, too.
std::vector<std::int32_t> first_at_place(const MeshDescription& description) {
  const PointFinder finder(description.vertices, PointFinder::default_tolerance(description.vertices));
  std::vector<std::int32_t> first(description.vertices.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    const auto vertex = static_cast<std::int32_t>(i);
    const std::int32_t other = finder.find(description.vertices[i], vertex);
    first[i] = other == none || other > vertex ? vertex : first[other];
  }
  return first;
}

FacetVertices mapped(const MeshDescription& description, FacetVertices facet, const std::vector<std::int32_t>& first) {
  for (int i = 0; i < description.dimension; ++i) facet[i] = first[facet[i]];
  insertion_sort(facet, description.dimension);
  return facet;
}

/// A facet of a cell by its places, and by its vertices.
struct PlacedFacet {
  FacetVertices place;
  FacetVertices vertices;

  auto operator<=>(const PlacedFacet&) const = default;
};

/// The facets of cells that have a vertex which is not alone at its place, each once, sorted by places.
std::vector<PlacedFacet> facets_with_doubled_vertices(const MeshDescription& description,
                                                      const std::vector<std::int32_t>& first) {
  std::vector<bool> is_doubled(first.size(), false);
  for (std::size_t vertex = 0; vertex < first.size(); ++vertex)
    if (first[vertex] != static_cast<std::int32_t>(vertex)) is_doubled[vertex] = is_doubled[first[vertex]] = true;
  std::vector<PlacedFacet> facets;
  for (const CellVertices& cell : description.cells)
    for (int facet = 0; facet <= description.dimension; ++facet) {
      FacetVertices vertices = facet_vertices(description.dimension, cell, facet);
      insertion_sort(vertices, description.dimension);
      if (std::any_of(vertices.begin(), vertices.begin() + description.dimension, [&](int v) { return is_doubled[v]; }))
        facets.push_back({mapped(description, vertices, first), vertices});
    }
  std::sort(facets.begin(), facets.end());
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  return facets;
}

}  // namespace

void merge_doubled_cracks(MeshDescription& description) {
  if (!description.use || description.use->cracks.empty()) return;
  const std::vector<std::int32_t> first = first_at_place(description);
  std::vector<bool> is_crack_place(first.size(), false);
  for (const NamedFacet& facet : description.named_facets)
    for (int i = 0; i < description.dimension && description.is_crack(facet.boundary); ++i)
      is_crack_place[first[facet.vertices[i]]] = true;
  std::vector<std::int32_t> new_index(first.size(), none);
  std::int32_t num_kept = 0;
  for (std::size_t vertex = 0; vertex < first.size(); ++vertex)
    if (!is_crack_place[first[vertex]] || first[vertex] == static_cast<std::int32_t>(vertex))
      new_index[vertex] = num_kept++;
  if (num_kept == static_cast<std::int32_t>(first.size())) return;
  const auto stays = [&](std::int32_t vertex) { return new_index[vertex] != none ? vertex : first[vertex]; };
  for (CellVertices& cell : description.cells)
    for (int corner = 0; corner <= description.dimension; ++corner) cell[corner] = stays(cell[corner]);
  for (NamedFacet& facet : description.named_facets)
    for (int i = 0; i < description.dimension; ++i) facet.vertices[i] = stays(facet.vertices[i]);
  renumber_vertices(description, new_index);
}

std::string find_doubled_side(const MeshDescription& description) {
  const std::vector<std::int32_t> first = first_at_place(description);
  const std::vector<PlacedFacet> facets = facets_with_doubled_vertices(description, first);
  const auto at_place = [](const PlacedFacet& facet, const FacetVertices& place) { return facet.place < place; };
  for (const NamedFacet& named : description.named_facets) {
    const FacetVertices place = mapped(description, named.vertices, first);
    const auto found = std::lower_bound(facets.begin(), facets.end(), place, at_place);
    if (found != facets.end() && found + 1 != facets.end() && found->place == place && (found + 1)->place == place)
      return description.boundary_names[named.boundary];
  }
  return "";
}

}  // namespace tentpole
