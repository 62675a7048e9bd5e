#include "host/mesh/box_mesh.hpp"

#include <cmath>
#include <string>

#include "host/mesh/mesh_description.hpp"
#include "host/mesh/printed_number.hpp"
#include "host/mesh/unstructured_lattice.hpp"

namespace tentpole {

namespace {

void check_box(const BoxMesh& box) {
  if (box.dimension < 1 || box.dimension > max_dimension)
    throw MeshError("box mesh", "", "dimension is " + std::to_string(box.dimension) + "; it must be 1, 2 or 3.");
  double num_vertices = 1;
  for (int axis = 0; axis < box.dimension; ++axis) {
    const std::string entity = std::string("axis ") + "xyz"[axis];
    if (box.cells[axis] < 1)
      throw MeshError("box mesh", entity, std::to_string(box.cells[axis]) + " cells; at least 1 is needed.");
    if (!(box.max[axis] > box.min[axis]) || !std::isfinite(box.max[axis] - box.min[axis]))
      throw MeshError("box mesh", entity,
                      "runs from " + printed(box.min[axis]) + " to " + printed(box.max[axis]) +
                          "; \"max\" must be greater than \"min\".");
    num_vertices *= box.cells[axis] + 1.0;
  }
  if (num_vertices > 2e8)
    throw MeshError("box mesh", "", printed(num_vertices) + " vertices; at most 2e8 are possible. Use fewer cells.");
}

/// Each cell facet on a side of the box gets that side's name.
void name_sides(const LatticeTriangulation& lattice, MeshDescription& description) {
  const std::array<std::string, 6> names{"left", "right", "bottom", "top", "back", "front"};
  description.boundary_names.assign(names.begin(), names.begin() + 2 * lattice.dimension);
  for (const CellVertices& cell : lattice.cells)
    for (int facet = 0; facet <= lattice.dimension; ++facet)
      for (int side = 0; side < 2 * lattice.dimension; ++side) {
        const int axis = side / 2, wanted = side % 2 == 0 ? 0 : lattice.num_boxes[axis];
        NamedFacet named{{none, none, none}, side};
        int num_on_side = 0;
        for (int corner = 0; corner <= lattice.dimension; ++corner)
          if (corner != facet && lattice.lattice_position(cell[corner])[axis] == wanted)
            named.vertices[num_on_side++] = cell[corner];
        if (num_on_side == lattice.dimension) description.named_facets.push_back(named);
      }
}

/// Convex combinations, so that the sides lie at min and max exactly.
Point physical_position(const BoxMesh& box, const Point& lattice_position) {
  Point position{};
  for (int axis = 0; axis < box.dimension; ++axis) {
    const double fraction = lattice_position[axis] / box.cells[axis];
    position[axis] = (1 - fraction) * box.min[axis] + fraction * box.max[axis];
  }
  return position;
}

}  // namespace

SpaceMesh make_box_mesh(const BoxMesh& box) {
  check_box(box);
  const LatticeTriangulation lattice = box.pattern == MeshPattern::structured
                                           ? structured_lattice(box.dimension, box.cells)
                                           : unstructured_lattice(box.dimension, box.cells, box.seed);
  MeshDescription description;
  description.source = "box mesh";
  description.dimension = box.dimension;
  for (const Point& position : lattice.vertices) description.vertices.push_back(physical_position(box, position));
  description.cells = lattice.cells;
  description.cell_region.assign(lattice.cells.size(), 0);
  description.region_names = {"all"};
  name_sides(lattice, description);
  return build_space_mesh(std::move(description), box.periodic);
}

}  // namespace tentpole
