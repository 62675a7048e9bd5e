#pragma once

#include "host/march/refinement.hpp"

namespace tentpole {

/// Fits the initial front to the cracks of the case ([[fracture.crack]]) and marks their edges: edges that a polyline
/// crosses are cut there; where it passes within 5 % of an edge's length from a vertex it goes through the vertex
/// instead, so that no slivers arise. D = 1: the cell is cut at the point. A crack that is a side of the mesh consists
/// of edges (D = 1: vertices) already. Call before the first patch. Throws InputError naming the crack and the point
/// where it leaves the domain or runs along its boundary.
void prepare_cracks(AdaptiveState& state);

}  // namespace tentpole
