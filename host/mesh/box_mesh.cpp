#include "host/mesh/box_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "host/mesh/mesh_description.hpp"
#include "host/mesh/printed_number.hpp"
#include "host/mesh/unstructured_lattice.hpp"

namespace tentpole {

namespace {

double width(const BoxMesh& box, int axis) {
  return (box.max[axis] - box.min[axis]) / box.cells[axis];
}

std::string width_text(const BoxMesh& box, int axis) {
  return "The cells of the box are " + printed(width(box, axis)) + " m wide in " + "xyz"[axis] + ", but ";
}

/// Advice where numbers are so far apart far from the origin that a cell is less than this many of them wide; or empty.
std::string far_advice(const BoxMesh& box, double numbers_per_cell) {
  for (int axis = 0; axis < box.dimension; ++axis) {
    const double largest = std::max(std::abs(box.min[axis]), std::abs(box.max[axis]));
    const double resolution = std::nextafter(largest, HUGE_VAL) - largest;
    if (width(box, axis) < numbers_per_cell * resolution)
      return width_text(box, axis) + "coordinates of " + printed(largest) + " m are " + printed(resolution) +
             " m apart. Move the box of [domain] nearer to the origin, or give fewer cells.";
  }
  return "";
}

/// Advice where cells are so thin that their vertices count as one; or empty.
std::string thin_advice(const BoxMesh& box) {
  double longest = 0;
  for (int axis = 0; axis < box.dimension; ++axis) longest = std::max(longest, box.max[axis] - box.min[axis]);
  for (int axis = 0; axis < box.dimension; ++axis)
    if (width(box, axis) < 1e-8 * longest)
      return width_text(box, axis) + "its longest side is " + printed(longest) +
             " m. Give [domain] sides and numbers of cells that make cells of more similar widths.";
  return "";
}

/// The way out of whatever is wrong with the mesh of a box: only rounding can be the reason. The likeliest comes first.
std::string rounding_advice(const BoxMesh& box) {
  for (const std::string& advice : {far_advice(box, 100), thin_advice(box), far_advice(box, 1e6)})
    if (!advice.empty()) return advice;
  return "Give the box of [domain] other numbers of cells.";
}

void check_box(const BoxMesh& box) {
  if (box.dimension < 1 || box.dimension > max_dimension)
    throw MeshError("box mesh", "", "dimension is " + std::to_string(box.dimension) + "; it must be 1, 2 or 3.");
  double num_vertices = 1;
  for (int axis = 0; axis < box.dimension; ++axis) {
    const std::string entity = std::string("axis ") + "xyz"[axis];
    if (box.cells[axis] < 1)
      throw MeshError("box mesh", entity, std::to_string(box.cells[axis]) + " cells; at least 1 is needed.");
    const std::string extent = "runs from " + printed(box.min[axis]) + " to " + printed(box.max[axis]);
    if (!(box.max[axis] > box.min[axis]))
      throw MeshError("box mesh", entity, extent + "; \"max\" must be greater than \"min\".");
    if (!(std::max(-box.min[axis], box.max[axis]) <= 1e100) || !(width(box, axis) >= 1e-100))
      throw MeshError("box mesh", entity,
                      extent + " in " + std::to_string(box.cells[axis]) +
                          " cells; coordinates may be at most 1e100 m, and cells at least 1e-100 m. Give metres.");
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
  description.generator_advice = rounding_advice(box);
  for (const Point& position : lattice.vertices) description.vertices.push_back(physical_position(box, position));
  description.cells = lattice.cells;
  description.cell_region.assign(lattice.cells.size(), 0);
  description.region_names = {"all"};
  name_sides(lattice, description);
  return build_space_mesh(std::move(description), box.periodic);
}

}  // namespace tentpole
