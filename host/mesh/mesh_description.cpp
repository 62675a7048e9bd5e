#include "host/mesh/mesh_description.hpp"

namespace tentpole {

namespace {

std::int64_t number_of(const std::vector<std::int64_t>& numbers, int index) {
  return numbers.empty() ? index : numbers[index];
}

template <typename Value>
void keep_only(std::vector<Value>& values, const std::vector<std::int32_t>& new_index) {
  if (values.empty()) return;
  std::size_t num_kept = 0;
  for (std::size_t i = 0; i < new_index.size(); ++i)
    if (new_index[i] != none) values[num_kept++] = values[i];
  values.resize(num_kept);
}

}  // namespace

std::string MeshDescription::cell_kind() const {
  return dimension == 1 ? "line" : dimension == 2 ? "triangle" : "tetrahedron";
}

std::string MeshDescription::vertex_label(int vertex) const {
  return "vertex " + std::to_string(number_of(vertex_number, vertex));
}

std::string MeshDescription::cell_label(int cell) const {
  return cell_kind() + " " + std::to_string(number_of(cell_number, cell));
}

std::string MeshDescription::facet_label(const FacetVertices& facet) const {
  if (dimension == 1) return vertex_label(facet[0]);
  std::string label = dimension == 2 ? "edge (" : "facet (";
  for (int i = 0; i < dimension; ++i) label += (i > 0 ? ", " : "") + std::to_string(number_of(vertex_number, facet[i]));
  return label + ")";
}

void renumber_vertices(MeshDescription& description, const std::vector<std::int32_t>& new_index) {
  std::erase_if(description.named_facets, [&](const NamedFacet& facet) {
    for (int i = 0; i < description.dimension; ++i)
      if (new_index[facet.vertices[i]] == none) return true;
    return false;
  });
  for (NamedFacet& facet : description.named_facets)
    for (int i = 0; i < description.dimension; ++i) facet.vertices[i] = new_index[facet.vertices[i]];
  for (CellVertices& cell : description.cells)
    for (int corner = 0; corner <= description.dimension; ++corner) cell[corner] = new_index[cell[corner]];
  keep_only(description.vertices, new_index);
  keep_only(description.vertex_number, new_index);
}

}  // namespace tentpole
