#pragma once

#include <array>

#include "host/mesh/space_mesh.hpp"

namespace tentpole {

/// |grad tau| of the linear function with the values `times` at the corners of a simplex [s/m]; the first
/// dimension + 1 entries are used.
double front_slope(int dimension, const std::array<Point, SpaceMesh::max_corners>& corners,
                   const std::array<double, SpaceMesh::max_corners>& times);

}  // namespace tentpole
