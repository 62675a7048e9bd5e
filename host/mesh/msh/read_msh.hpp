#pragma once

#include <string>
#include <string_view>

#include "host/mesh/msh/msh_contents.hpp"

namespace tentpole {

/// Reads the bytes of a .msh file: version 2.0 to 2.2 or 4.1, text or binary of either byte order, with all sections of
/// the format. What is of no use here ($Periodic, $GhostElements, $Parametrizations, data, comments, unknown sections)
/// is passed over. `name` opens every message.
/// Memory is at most a small multiple of the size of the file, whatever numbers stand in it.
/// Throws MeshError with the line or byte and the entity where the file is not as the format says, for elements whose
/// nodes are not there, and for elements with a varying number of nodes (polygons, polyhedra).
MshContents read_msh(const std::string& name, std::string_view bytes);

}  // namespace tentpole
