#include "host/mesh/gmsh_file.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <memory>
#include <span>
#include <unordered_map>

#include "host/mesh/gmsh_module_loader.hpp"

namespace tentpole {

namespace {

std::span<const TentpoleGmshBlock> blocks_of(const TentpoleGmshMesh& file) {
  return {file.block, static_cast<std::size_t>(file.num_blocks)};
}

void check_header(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw MeshError(path, "", "cannot be opened. Check the name and the permissions.");
  std::string first_line;
  std::getline(stream, first_line);
  if (first_line.rfind("$MeshFormat", 0) != 0)
    throw MeshError(path, "line 1",
                    "is \"" + first_line.substr(0, 40) + "\" where a Gmsh mesh has \"$MeshFormat\". Save it as .msh.");
}

std::string first_element(const TentpoleGmshBlock& block) {
  return "element " + std::to_string(block.number[0]);
}

/// Elements that count are those of dimension D and D - 1; they must be linear simplices of at most one group.
void check_block(const std::string& path, int dimension, const TentpoleGmshBlock& block) {
  if (block.num_elements == 0 || block.dimension < dimension - 1) return;
  if (block.dimension > dimension)
    throw MeshError(path, first_element(block),
                    std::string("is a ") + block.type_name + " of dimension " + std::to_string(block.dimension) +
                        ", but \"dimension\" is " + std::to_string(dimension) + ". Set the dimension of the mesh.");
  if (!block.is_linear_simplex)
    throw MeshError(path, first_element(block),
                    std::string("is a ") + block.type_name +
                        "; only lines, triangles and tetrahedra of order 1 are supported. Mesh with simplices of "
                        "order 1 (in Gmsh: no Recombine, Mesh.ElementOrder = 1).");
  if (block.num_groups > 1)
    throw MeshError(path, first_element(block),
                    std::string("belongs to two physical groups, ") + block.group_name[0] + " and " +
                        block.group_name[1] + ". Keep one.");
}

/// Index of a name in a list that grows.
std::int32_t name_index(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::int32_t>(found - names.begin());
  names.push_back(name);
  return static_cast<std::int32_t>(names.size() - 1);
}

using VertexIndex = std::unordered_map<std::int64_t, std::int32_t>;

VertexIndex add_vertices(const TentpoleGmshMesh& file, MeshDescription& description) {
  VertexIndex index;
  for (std::int64_t i = 0; i < file.num_vertices; ++i) {
    index[file.vertex_number[i]] = static_cast<std::int32_t>(i);
    description.vertex_number.push_back(file.vertex_number[i]);
    description.vertices.push_back({file.position[3 * i], file.position[3 * i + 1], file.position[3 * i + 2]});
  }
  return index;
}

void add_elements(const TentpoleGmshBlock& block, const VertexIndex& index, MeshDescription& description) {
  const bool is_cell = block.dimension == description.dimension;
  if (!is_cell && (block.dimension != description.dimension - 1 || block.num_groups == 0)) return;
  auto& names = is_cell ? description.region_names : description.boundary_names;
  const std::int32_t name = block.num_groups > 0 ? name_index(names, block.group_name[0]) : none;
  for (std::int64_t element = 0; element < block.num_elements; ++element) {
    CellVertices vertices{none, none, none, none};
    for (int i = 0; i < block.num_corners; ++i) vertices[i] = index.at(block.corner[element * block.num_corners + i]);
    if (is_cell) {
      description.cells.push_back(vertices);
      description.cell_region.push_back(name);
      description.cell_number.push_back(block.number[element]);
    } else {
      description.named_facets.push_back({{vertices[0], vertices[1], vertices[2]}, name});
    }
  }
}

}  // namespace

SpaceMesh read_gmsh_file(const std::string& path, int dimension, const PeriodicPairs& periodic) {
  check_header(path);
  const GmshModule& module = gmsh_module();
  const TentpoleGmshMesh file = module.read(path.c_str());
  const std::unique_ptr<void, std::function<void(void*)>> release(file.owner, [&](void*) { module.release(file); });
  if (file.error != nullptr) throw MeshError(path, "", std::string("is not readable: ") + file.error + ".");
  MeshDescription description;
  description.source = path;
  description.dimension = dimension;
  for (const TentpoleGmshBlock& block : blocks_of(file)) check_block(path, dimension, block);
  const VertexIndex index = add_vertices(file, description);
  for (const TentpoleGmshBlock& block : blocks_of(file)) add_elements(block, index, description);
  return build_space_mesh(std::move(description), periodic);
}

}  // namespace tentpole
