#include "host/mesh/lattice_triangulation.hpp"

#include <algorithm>
#include <numeric>

#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {

namespace {

using LatticePosition = std::array<int, max_dimension>;

int vertex_index(const LatticeTriangulation& lattice, const LatticePosition& position) {
  return position[0] + (lattice.num_boxes[0] + 1) * (position[1] + (lattice.num_boxes[1] + 1) * position[2]);
}

/// The diagonals of a row all lean to one side, those of the next row to the other.
void cut_rectangle(LatticeTriangulation& lattice, const LatticePosition& low) {
  const int a = vertex_index(lattice, low);
  const int b = a + 1, c = a + lattice.num_boxes[0] + 1, d = c + 1;
  if (low[1] % 2 == 0) {
    lattice.cells.push_back({a, b, d, none});
    lattice.cells.push_back({a, d, c, none});
  } else {
    lattice.cells.push_back({a, b, c, none});
    lattice.cells.push_back({b, d, c, none});
  }
}

/// Kuhn: one simplex for each order in which the axes are walked from the low to the high corner. Conforming, since the
/// faces of all boxes are cut alike.
void cut_box(LatticeTriangulation& lattice, const LatticePosition& low) {
  std::array<int, max_dimension> axes{0, 1, 2};
  do {
    LatticePosition position = low;
    CellVertices cell{none, none, none, none};
    cell[0] = vertex_index(lattice, position);
    for (int step = 0; step < lattice.dimension; ++step) {
      ++position[axes[step]];
      cell[step + 1] = vertex_index(lattice, position);
    }
    std::array<Point, SpaceMesh::max_corners> corners{};
    for (int i = 0; i <= lattice.dimension; ++i) corners[i] = lattice.vertices[cell[i]];
    if (signed_simplex_measure(lattice.dimension, corners) < 0) std::swap(cell[0], cell[1]);
    lattice.cells.push_back(cell);
  } while (std::next_permutation(axes.begin(), axes.begin() + lattice.dimension));
}

}  // namespace

LatticePosition LatticeTriangulation::lattice_position(int vertex) const {
  const int columns = num_boxes[0] + 1, rows = num_boxes[1] + 1;
  return {vertex % columns, vertex / columns % rows, vertex / (columns * rows)};
}

bool LatticeTriangulation::is_on_side(int vertex, int axis) const {
  const int position = lattice_position(vertex)[axis];
  return position == 0 || position == num_boxes[axis];
}

LatticeTriangulation structured_lattice(int dimension, const std::array<int, max_dimension>& num_boxes) {
  LatticeTriangulation lattice{dimension, {0, 0, 0}, {}, {}};
  std::copy_n(num_boxes.begin(), dimension, lattice.num_boxes.begin());
  const LatticePosition& n = lattice.num_boxes;
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i)
        lattice.vertices.push_back({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
  for (int k = 0; k < std::max(n[2], 1); ++k)
    for (int j = 0; j < std::max(n[1], 1); ++j)
      for (int i = 0; i < n[0]; ++i) {
        if (dimension == 2)
          cut_rectangle(lattice, {i, j, 0});
        else
          cut_box(lattice, {i, j, k});
      }
  return lattice;
}

}  // namespace tentpole
