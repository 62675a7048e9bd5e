#include "host/output/slice_cells.hpp"

#include <initializer_list>
#include <stdexcept>
#include <string>

namespace tentpole {
namespace {

using Point = std::array<double, 3>;

Point combine(std::initializer_list<double> weights, const Point* points) {
  Point result{};
  for (const double weight : weights) {
    for (int i = 0; i < 3; ++i) result[i] += weight * (*points)[i];
    ++points;
  }
  return result;
}

SliceCells subdivide_segment(const Slice& slice, int n) {
  SliceCells cells{slice.shape, {}, {}};
  for (int i = 0; i <= n; ++i) {
    const double s = static_cast<double>(i) / n;
    cells.points.push_back(combine({1 - s, s}, slice.point.data()));
    if (i < n) cells.connectivity.insert(cells.connectivity.end(), {i, i + 1});
  }
  return cells;
}

SliceCells subdivide_quad(const Slice& slice, int n) {
  SliceCells cells{slice.shape, {}, {}};
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double s = static_cast<double>(i) / n, t = static_cast<double>(j) / n;
      cells.points.push_back(combine({(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t}, slice.point.data()));
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int corner = j * (n + 1) + i;
      cells.connectivity.insert(cells.connectivity.end(), {corner, corner + 1, corner + n + 2, corner + n + 1});
    }
  return cells;
}

/// Triangle lattice: row j starts after j rows of n + 1, n, .. points.
int lattice(int n, int i, int j) {
  return j * (n + 1) - j * (j - 1) / 2 + i;
}

/// The n^2 triangles of the lattice over points 0, 1, 2.
std::vector<std::array<int, 3>> lattice_triangles(int n) {
  std::vector<std::array<int, 3>> triangles;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i + j < n; ++i) {
      triangles.push_back({lattice(n, i, j), lattice(n, i + 1, j), lattice(n, i, j + 1)});
      if (i + j + 1 < n) triangles.push_back({lattice(n, i + 1, j), lattice(n, i + 1, j + 1), lattice(n, i, j + 1)});
    }
  return triangles;
}

void append_lattice_points(const Point* corners, int n, std::vector<Point>& points) {
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i + j <= n; ++i) {
      const double s = static_cast<double>(i) / n, t = static_cast<double>(j) / n;
      points.push_back(combine({static_cast<double>(n - i - j) / n, s, t}, corners));
    }
}

SliceCells subdivide_triangle(const Slice& slice, int n) {
  SliceCells cells{slice.shape, {}, {}};
  append_lattice_points(slice.point.data(), n, cells.points);
  for (const auto& triangle : lattice_triangles(n))
    cells.connectivity.insert(cells.connectivity.end(), triangle.begin(), triangle.end());
  return cells;
}

SliceCells subdivide_wedge(const Slice& slice, int n) {
  SliceCells cells{slice.shape, {}, {}};
  for (int layer = 0; layer <= n; ++layer) {
    const double s = static_cast<double>(layer) / n;
    std::array<Point, 3> corners;
    for (int corner = 0; corner < 3; ++corner) {
      const Point ends[] = {slice.point[corner], slice.point[corner + 3]};
      corners[corner] = combine({1 - s, s}, ends);
    }
    append_lattice_points(corners.data(), n, cells.points);
  }
  const int layer_points = (n + 1) * (n + 2) / 2;
  for (int layer = 0; layer < n; ++layer)
    for (const auto& triangle : lattice_triangles(n))
      for (const int above : {0, 1})
        for (const int point : triangle) cells.connectivity.push_back((layer + above) * layer_points + point);
  return cells;
}

/// n = 2: four corner tetrahedra and the inner octahedron cut along the diagonal between the middles of 01 and 23.
SliceCells subdivide_tetrahedron(const Slice& slice, int n) {
  SliceCells cells{slice.shape, {slice.point.begin(), slice.point.begin() + 4}, {0, 1, 2, 3}};
  if (n == 1) return cells;
  // Middles of the edges 01, 02, 03, 12, 13, 23 become points 4..9.
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const Point ends[] = {slice.point[i], slice.point[j]};
      cells.points.push_back(combine({0.5, 0.5}, ends));
    }
  cells.connectivity = {0, 4, 5, 6, 4, 1, 7, 8, 5, 7, 2, 9, 6, 8, 9, 3, 4, 9, 5, 6, 4, 9, 6, 8, 4, 9, 8, 7, 4, 9, 7, 5};
  return cells;
}

}  // namespace

int num_corners(SliceShape shape) {
  switch (shape) {
    case SliceShape::segment:
      return 2;
    case SliceShape::triangle:
      return 3;
    case SliceShape::quad:
    case SliceShape::tetrahedron:
      return 4;
    case SliceShape::wedge:
      return 6;
  }
  throw std::invalid_argument("no such slice shape: " + std::to_string(static_cast<int>(shape)));
}

SliceCells subdivide(const Slice& slice, int num_subdivisions) {
  if (num_subdivisions < 1 || (slice.shape == SliceShape::tetrahedron && num_subdivisions > 2))
    throw std::invalid_argument("a slice cannot be cut into " + std::to_string(num_subdivisions) + " parts per edge");
  switch (slice.shape) {
    case SliceShape::segment:
      return subdivide_segment(slice, num_subdivisions);
    case SliceShape::triangle:
      return subdivide_triangle(slice, num_subdivisions);
    case SliceShape::quad:
      return subdivide_quad(slice, num_subdivisions);
    case SliceShape::wedge:
      return subdivide_wedge(slice, num_subdivisions);
    case SliceShape::tetrahedron:
      return subdivide_tetrahedron(slice, num_subdivisions);
  }
  throw std::invalid_argument("no such slice shape: " + std::to_string(static_cast<int>(slice.shape)));
}

int default_subdivisions(int dimension, int degree) {
  if (dimension < 3) return degree;
  return degree < 3 ? 1 : 2;
}

}  // namespace tentpole
