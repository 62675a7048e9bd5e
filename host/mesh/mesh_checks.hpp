#pragma once

#include <string>
#include <vector>

#include "host/mesh/mesh_description.hpp"

namespace tentpole {

/// Removes the vertices that no cell uses and renumbers the rest in the same order; says so in `warnings`. Throws
/// MeshError where a crack (NameUse) would lose a facet.
void drop_unused_vertices(MeshDescription& description, std::vector<std::string>& warnings);

/// Throws MeshError for a coordinate that is not finite, or one that does not belong to the dimension (z != 0 in a
/// plane mesh).
void check_coordinates(const MeshDescription& description);

/// Throws MeshError for two vertices at the same place (closer than 1e-9 of the domain's longest side). Coordinates
/// must be finite.
void check_places(const MeshDescription& description);

/// Throws MeshError if there is no cell, or for a cell without a region, with a corner twice, or degenerate: its
/// measure is below 1e-10 of its longest edge to the power D.
void check_cells(const MeshDescription& description);

}  // namespace tentpole
