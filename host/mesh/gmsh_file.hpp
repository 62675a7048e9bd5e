#pragma once

#include <string>

#include "host/mesh/mesh_description.hpp"

namespace tentpole {

/// Reads a Gmsh mesh file (.msh, version 2.2 or 4.1, ASCII or binary) of linear simplices. Physical groups of dimension
/// D name the regions, those of dimension D - 1 the boundaries; lower elements are ignored. Coordinates are taken as
/// [m]. Needs the module tentpole_gmsh_module.so, looked for beside the executable, in ../lib/tentpole and in the build
/// folder. Throws MeshError with file and entity for: an unreadable file; elements other than linear simplices, by
/// name; elements of a higher dimension; an element in two physical groups; and for all that build_space_mesh refuses.
SpaceMesh read_gmsh_file(const std::string& path, int dimension, const PeriodicPairs& periodic = {});

}  // namespace tentpole
