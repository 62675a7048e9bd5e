#pragma once

#include "host/problem/simulation.hpp"

namespace tentpole {

/// Generates or reads the mesh and matches its names with the case.
/// Throws InputError where the mesh or the run would need more memory than there is, for boundaries without a
/// condition, regions without a material and names that the mesh lacks (all at once), MeshError for a mesh that cannot
/// be used.
Simulation make_simulation(Case settings);

}  // namespace tentpole
