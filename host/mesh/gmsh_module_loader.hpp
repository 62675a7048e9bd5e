#pragma once

#include "host/mesh/gmsh_module.h"

namespace tentpole {

/// Functions of the loaded module.
struct GmshModule {
  decltype(&tentpole_gmsh_read) read;
  decltype(&tentpole_gmsh_release) release;
};

/// Loads the module at the first call and keeps it. Throws std::runtime_error with the places searched if there is
/// none.
const GmshModule& gmsh_module();

}  // namespace tentpole
