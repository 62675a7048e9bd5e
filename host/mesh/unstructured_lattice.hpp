#pragma once

#include <cstdint>

#include "host/mesh/lattice_triangulation.hpp"

namespace tentpole {

/// The unstructured pattern of make_box_mesh, still in units of the boxes. Opposite sides keep the same mesh.
LatticeTriangulation unstructured_lattice(int dimension, const std::array<int, max_dimension>& num_boxes,
                                          std::uint64_t seed);

/// Shape of a positively oriented simplex: 1 for equal edges, 0 for a degenerate, < 0 for an inverted one.
/// D = 2: 4 sqrt(3) A / sum l^2; D = 3: 72 sqrt(3) V / (sum l^2)^(3/2); D = 1: the sign of the length.
double simplex_shape(int dimension, const std::array<Point, SpaceMesh::max_corners>& corners);

}  // namespace tentpole
