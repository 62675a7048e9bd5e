#pragma once

#include <array>
#include <vector>

#include "host/output/slice.hpp"

namespace tentpole {

/// A slice cut into cells of its own shape; they share the points inside the slice.
struct SliceCells {
  SliceShape shape{};
  std::vector<std::array<double, 3>> points;  ///< [m]
  std::vector<int> connectivity;              ///< corners of each cell, one cell after the other
};

/// Corners of a cell of this shape.
int num_corners(SliceShape shape);

/// Cuts every edge of the slice into `num_subdivisions` parts so that curved fields are seen in linear cells: n
/// segments, n^2 triangles or quads, n^3 tetrahedra or wedges. Throws std::invalid_argument unless 1 <= n, and n <= 2
/// for tetrahedra.
SliceCells subdivide(const Slice& slice, int num_subdivisions);

/// The number that shows degree k well: k for D = 1, 2; for D = 3, where cells grow with its cube, 2 from k = 3 on.
int default_subdivisions(int dimension, int degree);

}  // namespace tentpole
