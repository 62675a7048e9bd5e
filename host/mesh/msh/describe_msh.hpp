#pragma once

#include <optional>
#include <string>

#include "host/mesh/mesh_description.hpp"
#include "host/mesh/msh/msh_contents.hpp"

namespace tentpole {

/// Makes the description of a mesh of dimension D from what a .msh file says: cells are its elements of dimension D,
/// and their groups are regions; named facets its elements of dimension D - 1 that are in groups; lower ones are
/// ignored. An element of version 2 that is in several groups stands there once for each of them, and is one cell.
/// Where `use` is given, a cell of several groups has the region that is used (NameUse).
/// Throws MeshError with the element for elements other than linear simplices, by name; elements of a higher dimension;
/// and a cell in two groups that are used.
MeshDescription describe_msh(const std::string& source, const MshContents& contents, int dimension,
                             const std::optional<NameUse>& use);

}  // namespace tentpole
