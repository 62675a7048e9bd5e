#pragma once

#include "host/mesh/space_mesh.hpp"

namespace tentpole::testing {

/// A regular polygon of radius 1 round vertex `num_sides` at `centre`; one boundary "side", one region.
SpaceMesh polygon_mesh(int num_sides, const Point& centre = {0, 0, 0});

}  // namespace tentpole::testing
