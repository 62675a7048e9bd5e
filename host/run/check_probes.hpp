#pragma once

#include "host/problem/simulation.hpp"

namespace tentpole {

/// Every probe must lie in a cell of the mesh, its facets included. Throws InputError with all that do not.
void check_probes(const Simulation& simulation);

}  // namespace tentpole
