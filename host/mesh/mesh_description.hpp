#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/mesh/mesh_error.hpp"
#include "host/mesh/name_use.hpp"
#include "host/mesh/space_mesh.hpp"

namespace tentpole {

/// Corners of a simplex, as vertex indices; unused entries are `none`.
using CellVertices = std::array<std::int32_t, SpaceMesh::max_corners>;
using FacetVertices = std::array<std::int32_t, max_dimension>;

/// A facet and its name.
struct NamedFacet {
  FacetVertices vertices;  ///< dimension of them, any order
  std::int32_t boundary;   ///< index into boundary_names
};

/// What a generator or a mesh file says, before anything is checked. Indices count from 0; the numbers by which the
/// source calls its vertices and cells are kept for messages.
struct MeshDescription {
  std::string source;  ///< file name, or what generated it; opens every message
  int dimension = 0;
  std::vector<Point> vertices;            ///< [m]
  std::vector<CellVertices> cells;        ///< any orientation, any order of corners
  std::vector<std::int32_t> cell_region;  ///< index into region_names, or none
  std::vector<NamedFacet> named_facets;   ///< a facet may come several times, with different names
  std::vector<std::string> region_names;
  std::vector<std::string> boundary_names;
  std::vector<std::int64_t> vertex_number;  ///< as in the source; empty: the index
  std::vector<std::int64_t> cell_number;    ///< as in the source; empty: the index
  std::optional<NameUse> use;               ///< what the case does with the names; absent: all are used
  std::string generator_advice;             ///< the way out of whatever is wrong with a generated mesh; empty: a file

  /// The way out for a message: `for_file`, or what the generator advises.
  const std::string& way_out(const std::string& for_file) const {
    return generator_advice.empty() ? for_file : generator_advice;
  }
  bool is_crack(std::int32_t boundary) const { return use && use->has_crack(boundary_names[boundary]); }

  std::string vertex_label(int vertex) const;                    ///< "vertex 17"
  std::string cell_label(int cell) const;                        ///< "triangle 4", after the dimension
  std::string facet_label(const FacetVertices& vertices) const;  ///< "edge (3, 4)", by vertex numbers
  std::string cell_kind() const;                                 ///< "line", "triangle", "tetrahedron"
};

/// Removes the vertices whose new index is none, and renumbers the others; new indices ascend. Cells must not use the
/// removed ones; named facets that do are removed, too.
void renumber_vertices(MeshDescription& description, const std::vector<std::int32_t>& new_index);

/// Checks a description, joins what is doubled at cracks, drops unused vertices (with a warning) and identifies
/// periodic sides. Vertices keep their order, so the result is a function of the description alone. Throws MeshError
/// with the entity's number for: no cells; a coordinate that is not finite; a degenerate cell; two cells on the same
/// side of their facet (one is inverted); more than two cells at a facet; a hanging node; a boundary facet without a
/// name; a cell without a region; two vertices at one place; a crack side that is not inside; periodic sides that do
/// not match, or a periodic domain so small that a cell meets itself.
SpaceMesh build_space_mesh(MeshDescription description, const PeriodicPairs& periodic = {});

}  // namespace tentpole
