#include "host/mesh/unstructured_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host/mesh/planar_delaunay.hpp"
#include "host/mesh/random_offset.hpp"
#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {

namespace {

/// Largest displacements in units of a box, by dimension. Inner vertices are displaced only as far as all shapes round
/// them stay above min_shape; side vertices move along their side, so little that no check is needed.
constexpr std::array<double, 4> inner_amplitude{0, 0.3, 0.45, 0.3};
constexpr std::array<double, 4> side_amplitude{0, 0, 0.15, 0.08};
constexpr std::array<double, 4> min_shape{0, 0, 0.35, 0.45};
constexpr int num_smoothing_rounds = 4;

/// Cells round each vertex, CSR.
struct Stars {
  std::vector<std::int32_t> offset;
  std::vector<std::int32_t> cell;

  explicit Stars(const LatticeTriangulation& lattice) : offset(lattice.vertices.size() + 1, 0) {
    for (const CellVertices& vertices : lattice.cells)
      for (int i = 0; i <= lattice.dimension; ++i) ++offset[vertices[i] + 1];
    std::partial_sum(offset.begin(), offset.end(), offset.begin());
    cell.resize(offset.back());
    std::vector<std::int32_t> next(offset.begin(), offset.end() - 1);
    for (std::size_t c = 0; c < lattice.cells.size(); ++c)
      for (int i = 0; i <= lattice.dimension; ++i) cell[next[lattice.cells[c][i]]++] = static_cast<std::int32_t>(c);
  }
};

double worst_shape(const LatticeTriangulation& lattice, const Stars& stars, int vertex) {
  double worst = 1;
  for (int entry = stars.offset[vertex]; entry < stars.offset[vertex + 1]; ++entry) {
    std::array<Point, SpaceMesh::max_corners> corners{};
    for (int i = 0; i <= lattice.dimension; ++i) corners[i] = lattice.vertices[lattice.cells[stars.cell[entry]][i]];
    worst = std::min(worst, simplex_shape(lattice.dimension, corners));
  }
  return worst;
}

bool is_inner(const LatticeTriangulation& lattice, int vertex) {
  for (int axis = 0; axis < lattice.dimension; ++axis)
    if (lattice.is_on_side(vertex, axis)) return false;
  return true;
}

/// Vertices that lie opposite each other on two sides draw the same numbers, so that sides match.
std::uint32_t random_item(const LatticeTriangulation& lattice, int vertex) {
  std::array<int, max_dimension> position = lattice.lattice_position(vertex);
  for (int axis = 0; axis < lattice.dimension; ++axis)
    if (position[axis] == lattice.num_boxes[axis]) position[axis] = 0;
  return static_cast<std::uint32_t>(position[0] + (lattice.num_boxes[0] + 1) *
                                                      (position[1] + (lattice.num_boxes[1] + 1) * position[2]));
}

void displace_side_vertices(LatticeTriangulation& lattice, std::uint64_t seed) {
  for (int vertex = 0; vertex < static_cast<int>(lattice.vertices.size()); ++vertex) {
    if (is_inner(lattice, vertex)) continue;
    for (int axis = 0; axis < lattice.dimension; ++axis)
      if (!lattice.is_on_side(vertex, axis))
        lattice.vertices[vertex][axis] +=
            side_amplitude[lattice.dimension] *
            random_offset(seed, random_item(lattice, vertex), static_cast<std::uint32_t>(axis));
  }
}

void displace_inner_vertices(LatticeTriangulation& lattice, std::uint64_t seed) {
  const Stars stars(lattice);
  for (int vertex = 0; vertex < static_cast<int>(lattice.vertices.size()); ++vertex) {
    if (!is_inner(lattice, vertex)) continue;
    const Point start = lattice.vertices[vertex];
    double amplitude = inner_amplitude[lattice.dimension];
    for (int attempt = 0; attempt < 5; ++attempt, amplitude /= 2) {
      for (int axis = 0; axis < lattice.dimension; ++axis)
        lattice.vertices[vertex][axis] = start[axis] + amplitude * random_offset(seed, random_item(lattice, vertex),
                                                                                 static_cast<std::uint32_t>(axis));
      if (worst_shape(lattice, stars, vertex) > min_shape[lattice.dimension]) break;
      lattice.vertices[vertex] = start;
    }
  }
}

/// Moves each inner vertex to the mean of its neighbours where that improves the worst shape round it.
void smooth_inner_vertices(LatticeTriangulation& lattice) {
  const Stars stars(lattice);
  for (int vertex = 0; vertex < static_cast<int>(lattice.vertices.size()); ++vertex) {
    if (!is_inner(lattice, vertex)) continue;
    const Point start = lattice.vertices[vertex];
    const double shape_before = worst_shape(lattice, stars, vertex);
    Point mean{};
    int num_corners = 0;
    for (int entry = stars.offset[vertex]; entry < stars.offset[vertex + 1]; ++entry)
      for (int i = 0; i <= lattice.dimension; ++i) {
        const int other = lattice.cells[stars.cell[entry]][i];
        if (other == vertex) continue;
        for (int axis = 0; axis < lattice.dimension; ++axis) mean[axis] += lattice.vertices[other][axis];
        ++num_corners;
      }
    for (int axis = 0; axis < lattice.dimension; ++axis) lattice.vertices[vertex][axis] = mean[axis] / num_corners;
    if (worst_shape(lattice, stars, vertex) <= shape_before) lattice.vertices[vertex] = start;
  }
}

}  // namespace

double simplex_shape(int dimension, const std::array<Point, SpaceMesh::max_corners>& corners) {
  const double measure = signed_simplex_measure(dimension, corners);
  if (dimension == 1) return measure > 0 ? 1 : -1;
  double square_sum = 0;
  for (int i = 0; i <= dimension; ++i)
    for (int j = 0; j < i; ++j) {
      const Point edge = difference(corners[i], corners[j]);
      square_sum += dot(edge, edge);
    }
  if (dimension == 2) return 4 * std::sqrt(3.0) * measure / square_sum;
  return 72 * std::sqrt(3.0) * measure / (square_sum * std::sqrt(square_sum));
}

LatticeTriangulation unstructured_lattice(int dimension, const std::array<int, max_dimension>& num_boxes,
                                          std::uint64_t seed) {
  LatticeTriangulation lattice = structured_lattice(dimension, num_boxes);
  displace_side_vertices(lattice, seed);
  displace_inner_vertices(lattice, seed);
  if (dimension != 2) return lattice;
  for (int round = 0; round < num_smoothing_rounds; ++round) {
    flip_to_delaunay(lattice.vertices, lattice.cells);
    smooth_inner_vertices(lattice);
  }
  return lattice;
}

}  // namespace tentpole
