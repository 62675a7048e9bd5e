#include "host/mesh/mesh_checks.hpp"

#include <cmath>
#include <limits>

#include "host/mesh/doubled_sides.hpp"
#include "host/mesh/point_finder.hpp"
#include "host/mesh/printed_number.hpp"
#include "host/mesh/simplex_geometry.hpp"
#include "host/mesh/toml_name.hpp"

namespace tentpole {

namespace {

/// Beyond these the product of three lengths is no normal number any more.
constexpr double smallest_length = 1e-100, largest_length = 1e100;

std::string printed_position(const Point& point) {
  return "(" + printed(point[0]) + ", " + printed(point[1]) + ", " + printed(point[2]) + ")";
}

std::string unused_vertices_warning(const MeshDescription& description, const std::vector<std::int32_t>& new_index,
                                    int num_dropped) {
  std::string list;
  int num_listed = 0;
  for (std::size_t i = 0; i < new_index.size() && num_listed < 5; ++i)
    if (new_index[i] == none) list += (num_listed++ > 0 ? ", " : "") + description.vertex_label(static_cast<int>(i));
  return description.source + ": " + std::to_string(num_dropped) + " vertices belong to no cell and are dropped (" +
         list + (num_dropped > num_listed ? ", ...)." : ").");
}

/// A crack must not lose a part silently because the mesh is not fitted to it.
void check_crack_vertices(const MeshDescription& description, const std::vector<std::int32_t>& new_index) {
  for (const NamedFacet& facet : description.named_facets)
    for (int i = 0; i < description.dimension; ++i)
      if (new_index[facet.vertices[i]] == none && description.is_crack(facet.boundary))
        throw MeshError(description.source, description.facet_label(facet.vertices),
                        "belongs to the crack " + description.boundary_names[facet.boundary] +
                            ", but to no cell, because " + description.vertex_label(facet.vertices[i]) +
                            " belongs to none. Fit the mesh to the crack (in Gmsh: embed its curve in the surface).");
}

[[noreturn]] void throw_same_place(const MeshDescription& description, std::int32_t vertex, std::int32_t other) {
  const std::string side = description.dimension < max_dimension ? find_doubled_side(description) : "";
  const std::string crack = "The side " + side + " is doubled there, as Gmsh's plugin Crack does: make it a crack " +
                            "([[fracture.crack]] with side = " + toml_string(side) + "), or merge";
  throw MeshError(
      description.source, description.vertex_label(vertex) + " and " + description.vertex_label(other),
      "both lie at " + printed_position(description.vertices[vertex]) + ". " +
          description.way_out((side.empty() ? "Merge" : crack) + " duplicate vertices (in Gmsh: Coherence Mesh)."));
}

}  // namespace

void drop_unused_vertices(MeshDescription& description, std::vector<std::string>& warnings) {
  std::vector<std::int32_t> new_index(description.vertices.size(), none);
  for (const CellVertices& cell : description.cells)
    for (int corner = 0; corner <= description.dimension; ++corner) new_index[cell[corner]] = 0;
  std::int32_t num_kept = 0;
  for (std::int32_t& index : new_index)
    if (index != none) index = num_kept++;
  const int num_dropped = static_cast<int>(new_index.size()) - num_kept;
  if (num_dropped == 0) return;
  check_crack_vertices(description, new_index);
  warnings.push_back(unused_vertices_warning(description, new_index, num_dropped));
  renumber_vertices(description, new_index);
}

void check_coordinates(const MeshDescription& description) {
  const auto& vertices = description.vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (int axis = 0; axis < max_dimension; ++axis)
      if (!(std::abs(vertices[i][axis]) <= largest_length))
        throw MeshError(
            description.source, description.vertex_label(static_cast<int>(i)),
            "its position is " + printed_position(vertices[i]) + ". Coordinates must be finite, and at most 1e100 m.");
  const double tolerance = PointFinder::default_tolerance(vertices);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (int axis = description.dimension; axis < max_dimension; ++axis)
      if (std::abs(vertices[i][axis]) > tolerance)
        throw MeshError(description.source, description.vertex_label(static_cast<int>(i)),
                        "its position is " + printed_position(vertices[i]) + ", but a mesh of dimension " +
                            std::to_string(description.dimension) + " must lie " +
                            (description.dimension == 1 ? "on the x axis." : "in the plane z = 0.") +
                            " Move it there, or set \"dimension\".");
}

void check_places(const MeshDescription& description) {
  const auto& vertices = description.vertices;
  const PointFinder finder(vertices, PointFinder::default_tolerance(vertices));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::int32_t other = finder.find(vertices[i], static_cast<std::int32_t>(i));
    if (other != none) throw_same_place(description, static_cast<std::int32_t>(i), other);
  }
}

void check_cells(const MeshDescription& description) {
  if (description.cells.empty())
    throw MeshError(description.source, "",
                    "there is no " + description.cell_kind() + " in the mesh, but \"dimension\" is " +
                        std::to_string(description.dimension) + ". Mesh the domain, or set the dimension.");
  const std::size_t most_cells = std::numeric_limits<std::int32_t>::max() / (description.dimension + 1);
  if (description.cells.size() > most_cells)
    throw MeshError(description.source, "",
                    "there are " + std::to_string(description.cells.size()) + " cells; at most " +
                        std::to_string(most_cells) + " are possible. " + description.way_out("Mesh more coarsely."));
  for (int cell = 0; cell < static_cast<int>(description.cells.size()); ++cell) {
    const CellVertices& vertices = description.cells[cell];
    if (description.cell_region[cell] == none)
      throw MeshError(description.source, description.cell_label(cell),
                      "belongs to no region. Put it into a physical group of dimension " +
                          std::to_string(description.dimension) + ".");
    std::array<Point, SpaceMesh::max_corners> corners{};
    for (int i = 0; i <= description.dimension; ++i) corners[i] = description.vertices[vertices[i]];
    const double measure = std::abs(signed_simplex_measure(description.dimension, corners));
    const double longest = longest_edge(description.dimension, corners);
    if (longest < smallest_length)
      throw MeshError(description.source, description.cell_label(cell),
                      "is too small: its longest edge is " + printed(longest) +
                          " m, but at least 1e-100 m are needed. " +
                          description.way_out("Give coordinates in metres."));
    if (!(measure > 1e-10 * std::pow(longest, description.dimension)))
      throw MeshError(description.source, description.cell_label(cell),
                      "is degenerate: its measure is " + printed(measure) + ", its longest edge " + printed(longest) +
                          ". " + description.way_out("Repair the mesh."));
  }
}

}  // namespace tentpole
