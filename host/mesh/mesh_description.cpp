#include "host/mesh/mesh_description.hpp"

namespace tentpole {

namespace {

std::int64_t number_of(const std::vector<std::int64_t>& numbers, int index) {
  return numbers.empty() ? index : numbers[index];
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

}  // namespace tentpole
