#pragma once

#include <vector>

#include "host/mesh/mesh_description.hpp"

namespace tentpole {

/// Flips the edges of a valid triangulation of a convex polygon until no vertex lies inside the circle round a triangle
/// (Lawson 1977). `triangles`: counterclockwise vertex triples; boundary edges stay. A flip is done only if it gains
/// more than rounding, so the loop ends and triangles on one circle stay as they are.
void flip_to_delaunay(const std::vector<Point>& vertices, std::vector<CellVertices>& triangles);

}  // namespace tentpole
