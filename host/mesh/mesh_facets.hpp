#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "host/mesh/mesh_description.hpp"

namespace tentpole {

/// Who lies across each facet of each cell; facet i of a cell is opposite its i-th corner.
struct FacetTable {
  std::vector<CellVertices> neighbor;                                            ///< cell, or none
  std::vector<std::array<std::uint8_t, SpaceMesh::max_corners>> neighbor_facet;  ///< seen from the neighbour
  std::vector<CellVertices> boundary;  ///< index into boundary_names; none inside and where a name is missing
};

/// Vertices of facet `facet` of a cell, in the order of its corners.
FacetVertices facet_vertices(int dimension, const CellVertices& cell, int facet);

/// Pairs the cells at each facet. The corners of every cell must ascend.
/// Throws MeshError where more than two cells meet at a facet.
FacetTable match_facets(const MeshDescription& description);

/// Throws MeshError where two neighbours lie on the same side of their common facet: one of them is inverted.
void check_cells_do_not_overlap(const MeshDescription& description, const FacetTable& facets);

/// Gives the boundary facets their names. Named facets that lie inside the domain or belong to no cell are ignored,
/// with a sentence in `warnings`. A facet of several names has the one that is used (NameUse). Throws MeshError where
/// two of them are.
void name_boundary_facets(const MeshDescription& description, FacetTable& facets, std::vector<std::string>& warnings);

/// Throws MeshError at a boundary facet without a name; it is called a hanging node where another vertex lies on the
/// facet.
void check_boundary_is_named(const MeshDescription& description, const FacetTable& facets);

}  // namespace tentpole
