#pragma once

#include <optional>
#include <string>

#include "host/mesh/mesh_description.hpp"

namespace tentpole {

/// Reads a Gmsh mesh file (.msh, version 2.2 or 4.1, ASCII or binary) of linear simplices. Physical groups of dimension
/// D name the regions, those of dimension D - 1 the boundaries; lower elements are ignored. Coordinates are taken as
/// [m]. `use` says which names count where groups overlap; without it no two may.
/// Throws MeshError for an unreadable file, with the line or byte and the entity (msh/read_msh.hpp); for what the
/// elements may not be (msh/describe_msh.hpp); and for all that build_space_mesh refuses.
SpaceMesh read_gmsh_file(const std::string& path, int dimension, const PeriodicPairs& periodic = {},
                         const std::optional<NameUse>& use = {});

}  // namespace tentpole
