#pragma once

#include <array>
#include <vector>

#include "host/mesh/mesh_description.hpp"

namespace tentpole {

/// A box of unit cells cut into simplices: vertex (i, j, k) starts at these coordinates and has the index
/// i + (n0 + 1) (j + (n1 + 1) k). Axes beyond the dimension have n = 0.
struct LatticeTriangulation {
  int dimension;
  std::array<int, max_dimension> num_boxes;  ///< n0, n1, n2
  std::vector<Point> vertices;
  std::vector<CellVertices> cells;  ///< positively oriented

  std::array<int, max_dimension> lattice_position(int vertex) const;

  /// Whether the vertex lies on the lower or upper side of this axis.
  bool is_on_side(int vertex, int axis) const;
};

/// The structured pattern of make_box_mesh.
LatticeTriangulation structured_lattice(int dimension, const std::array<int, max_dimension>& num_boxes);

}  // namespace tentpole
