#pragma once

#include "host/problem/simulation.hpp"
#include "kernels/element/patch_batch.hpp"

namespace tentpole {

/// A cell of the flat initial front as the lower facet D + 1 of an element, for PrescribedData: its corners at time 0
/// and the material; the last corner is at the origin until somebody moves it. Scaled.
ElementDescriptor initial_element(const Simulation& simulation, int cell);

}  // namespace tentpole
