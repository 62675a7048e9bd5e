#pragma once

#include <cstdint>
#include <vector>

#include "host/front/front_mesh.hpp"

namespace tentpole {

/// The vertices round a vertex, or those on one side of its line, as the corners of a polygon.
struct RingPart {
  std::vector<std::int32_t> vertices;  ///< counter-clockwise; for a line vertex from one end of the line to the other
  std::int32_t region;
};

/// D = 2. What remains when a vertex that is no corner is taken out: one polygon for an interior vertex (from its
/// smallest id on) and for one on the boundary, two for one on an interface (by their first vertex).
std::vector<RingPart> vertex_ring(const FrontMesh& mesh, int vertex);

}  // namespace tentpole
