#pragma once

#include <string>
#include <vector>

#include "host/mesh/mesh_description.hpp"

namespace tentpole {

/// Which name counts for a cell in groups of these names, which are not none. Throws MeshError for `cell` if two of
/// them are used.
std::size_t chosen_region(const MeshDescription& mesh, const std::vector<std::string>& names, const std::string& cell);

/// Keeps one of the cells that have the same corners but different regions, with the region that counts. Cells with the
/// same corners and the same region are a fault of the mesh and stay.
void merge_repeated_cells(MeshDescription& mesh);

}  // namespace tentpole
