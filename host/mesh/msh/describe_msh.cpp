#include "host/mesh/msh/describe_msh.hpp"

#include <algorithm>
#include <map>

#include "host/mesh/msh/group_names.hpp"
#include "host/mesh/msh/repeated_cells.hpp"

namespace tentpole {

namespace {

/// Elements that count are those of dimension D and D - 1; they must be linear simplices.
void check_block(const MeshDescription& mesh, const MshContents& contents, const MshBlock& block) {
  const MshElementType& type = *block.type;
  if (block.num_elements == 0 || type.dimension < mesh.dimension - 1) return;
  const std::string element = "element " + std::to_string(contents.element_label[block.first]);
  if (type.dimension > mesh.dimension)
    throw MeshError(mesh.source, element,
                    "is a " + type.name() + " of dimension " + std::to_string(type.dimension) +
                        ", but \"dimension\" is " + std::to_string(mesh.dimension) +
                        ". Set the dimension of the mesh.");
  if (!type.is_linear_simplex)
    throw MeshError(mesh.source, element,
                    "is a " + type.name() +
                        "; only lines, triangles and tetrahedra of order 1 are supported. Mesh with simplices of "
                        "order 1 (in Gmsh: no Recombine, Mesh.ElementOrder = 1).");
}

/// Adds the elements of blocks to a description, with the names of their groups.
class ElementAdder {
 public:
  ElementAdder(const MshContents& contents, MeshDescription& mesh)
      : contents_(contents), mesh_(mesh), group_names_(contents, mesh.use) {}

  void add_cells(const MshBlock& block) {
    const std::vector<std::string>& names = group_names_.of_cells(block);
    std::int32_t region = none;
    if (!names.empty()) {
      const std::string first = mesh_.cell_kind() + " " + std::to_string(contents_.element_label[block.first]);
      region = index_of(names[chosen_region(mesh_, names, first)], mesh_.region_names, region_index_);
    }
    for (std::size_t element = 0; element < block.num_elements; ++element) {
      CellVertices vertices{none, none, none, none};
      std::copy_n(corners(block, element), mesh_.dimension + 1, vertices.begin());
      mesh_.cells.push_back(vertices);
      mesh_.cell_region.push_back(region);
      mesh_.cell_number.push_back(contents_.element_label[block.first + element]);
    }
  }

  /// A facet of several groups comes with each of the names that count; name_facets chooses.
  void add_facets(const MshBlock& block) {
    for (const std::string& name : group_names_.of_facets(block)) {
      const std::int32_t boundary = index_of(name, mesh_.boundary_names, boundary_index_);
      for (std::size_t element = 0; element < block.num_elements; ++element) {
        NamedFacet facet{{none, none, none}, boundary};
        std::copy_n(corners(block, element), mesh_.dimension, facet.vertices.begin());
        mesh_.named_facets.push_back(facet);
      }
    }
  }

 private:
  using NameIndex = std::map<std::string, std::int32_t>;

  static std::int32_t index_of(const std::string& name, std::vector<std::string>& names, NameIndex& index) {
    const auto [found, is_new] = index.try_emplace(name, static_cast<std::int32_t>(names.size()));
    if (is_new) names.push_back(name);
    return found->second;
  }

  const std::int32_t* corners(const MshBlock& block, std::size_t element) const {
    return &contents_.element_node[block.first_corner + element * block.type->num_nodes];
  }

  const MshContents& contents_;
  MeshDescription& mesh_;
  GroupNames group_names_;
  NameIndex region_index_, boundary_index_;
};

}  // namespace

MeshDescription describe_msh(const std::string& source, const MshContents& contents, int dimension,
                             const std::optional<NameUse>& use) {
  MeshDescription mesh;
  mesh.source = source;
  mesh.dimension = dimension;
  mesh.use = use;
  for (const MshBlock& block : contents.blocks) check_block(mesh, contents, block);
  mesh.vertices = contents.node_position;
  mesh.vertex_number = contents.node_label;
  ElementAdder adder(contents, mesh);
  for (const MshBlock& block : contents.blocks) {
    if (block.num_elements == 0) continue;
    if (block.type->dimension == dimension) adder.add_cells(block);
    if (block.type->dimension == dimension - 1) adder.add_facets(block);
  }
  if (!contents.has_entities) merge_repeated_cells(mesh);
  return mesh;
}

}  // namespace tentpole
