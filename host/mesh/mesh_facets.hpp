#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "host/mesh/mesh_description.hpp"

namespace tentpole {

/// A facet as its sorted vertices, with the cell it is seen from.
struct FacetOfCell {
  FacetVertices vertices;
  std::int32_t cell;
  std::int32_t facet;

  auto operator<=>(const FacetOfCell&) const = default;
};

/// Who lies across each facet of each cell; facet i of a cell is opposite its i-th corner.
struct FacetTable {
  std::vector<FacetOfCell> sorted;                                               ///< all facets of all cells
  std::vector<CellVertices> neighbor;                                            ///< cell, or none
  std::vector<std::array<std::uint8_t, SpaceMesh::max_corners>> neighbor_facet;  ///< seen from the neighbour
  std::vector<CellVertices> boundary;  ///< index into boundary_names; none inside and where a name is missing
  std::vector<NamedFacet> inner;       ///< named facets between two cells, their vertices sorted
};

/// Vertices of facet `facet` of a cell, in the order of its corners.
FacetVertices facet_vertices(int dimension, const CellVertices& cell, int facet);

/// Pairs the cells at each facet. The corners of every cell must ascend.
/// Throws MeshError where more than two cells meet at a facet.
FacetTable match_facets(const MeshDescription& description);

/// Throws MeshError where two neighbours lie on the same side of their common facet: one of them is inverted.
void check_cells_do_not_overlap(const MeshDescription& description, const FacetTable& facets);

/// Gives the boundary facets their names, and collects the named facets inside. Those belong to no boundary: unless
/// they are cracks (NameUse), a sentence in `warnings` says so, and of named facets that belong to no cell. A facet of
/// several names has the one that is used. Throws MeshError where two of them are, and for a facet of a crack that is
/// not inside.
void name_facets(const MeshDescription& description, FacetTable& facets, std::vector<std::string>& warnings);

/// Throws MeshError at a boundary facet without a name; it is called a hanging node where another vertex lies on the
/// facet.
void check_boundary_is_named(const MeshDescription& description, const FacetTable& facets);

}  // namespace tentpole
