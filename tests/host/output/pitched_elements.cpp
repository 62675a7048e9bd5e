#include "tests/host/output/pitched_elements.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include "common/simplex.hpp"
#include "kernels/element/quadrature.hpp"

namespace tentpole {
namespace {

struct BoxMesh {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::vector<int>> cells;
};

int vertex_index(const PitchedBox& box, const std::array<int, 3>& place) {
  int index = 0, stride = 1;
  for (int i = 0; i < box.dimension; ++i) {
    index += stride * place[i];
    stride *= box.cells[i] + 1;
  }
  return index;
}

/// Calls `visit` for all places with place[i] < limit[i].
template <class Visit>
void for_each_place(int dimension, std::array<int, 3> limit, Visit visit) {
  for (int i = dimension; i < 3; ++i) limit[i] = 1;
  for (int z = 0; z < limit[2]; ++z)
    for (int y = 0; y < limit[1]; ++y)
      for (int x = 0; x < limit[0]; ++x) visit(std::array<int, 3>{x, y, z});
}

/// Kuhn's simplices of the grid cube at `place`: one path from its lowest to its highest corner per order of the axes.
void append_kuhn_cells(const PitchedBox& box, const std::array<int, 3>& place, std::vector<std::vector<int>>& cells) {
  std::vector<int> axes(box.dimension);
  std::iota(axes.begin(), axes.end(), 0);
  do {
    std::array<int, 3> corner = place;
    std::vector<int> cell{vertex_index(box, corner)};
    for (const int axis : axes) {
      ++corner[axis];
      cell.push_back(vertex_index(box, corner));
    }
    std::sort(cell.begin(), cell.end());
    cells.push_back(cell);
  } while (std::next_permutation(axes.begin(), axes.end()));
}

BoxMesh make_mesh(const PitchedBox& box, std::mt19937& generator) {
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  BoxMesh mesh;
  std::array<int, 3> num_vertices{};
  for (int i = 0; i < 3; ++i) num_vertices[i] = box.cells[i] + 1;
  for_each_place(box.dimension, num_vertices, [&](const std::array<int, 3>& place) {
    std::array<double, 3> vertex{};
    for (int i = 0; i < box.dimension; ++i) {
      const bool inner = place[i] > 0 && place[i] < box.cells[i];
      vertex[i] = box.length[i] * (place[i] + (inner ? shift(generator) : 0)) / box.cells[i];
    }
    mesh.vertices.push_back(vertex);
  });
  for_each_place(box.dimension, box.cells,
                 [&](const std::array<int, 3>& place) { append_kuhn_cells(box, place, mesh.cells); });
  return mesh;
}

std::vector<double> project(const PitchedBox& box, const OrthonormalBasis& basis, const Quadrature& rule,
                            const SpacetimeElement& element, const DisplacementField& field) {
  const int size = box.dimension + 1, num_basis = basis.size();
  std::vector<double> coefficients(box.dimension * num_basis), value(num_basis);
  for (int q = 0; q < rule.num_points(); ++q) {
    const double* xi = rule.points.data() + q * size;
    std::array<double, 4> event = element.corner[0];
    for (int l = 0; l < size; ++l)
      for (int c = 0; c < size; ++c) event[c] += xi[l] * (element.corner[l + 1][c] - element.corner[0][c]);
    const auto displacement = field(std::span<const double>(event).first(size));
    basis.values({xi, static_cast<std::size_t>(size)}, value);
    for (int i = 0; i < box.dimension; ++i)
      for (int a = 0; a < num_basis; ++a)
        coefficients[i * num_basis + a] += rule.weights[q] * displacement[i] * value[a];
  }
  return coefficients;
}

/// The simplex over `cell` with the old front below and the pole of `vertex` up to `top`.
SpacetimeElement tent_element(const PitchedBox& box, const BoxMesh& mesh, const std::vector<double>& time,
                              const std::vector<int>& cell, int vertex, double top) {
  SpacetimeElement element;
  element.dimension = box.dimension;
  element.material = box.material;
  double centre = 0;
  for (int corner = 0; corner <= box.dimension; ++corner) {
    const int v = cell[corner];
    for (int i = 0; i < box.dimension; ++i) element.corner[corner][i] = mesh.vertices[v][i];
    element.corner[corner][box.dimension] = time[v];
    if (v == vertex) element.corner[box.dimension + 1] = element.corner[corner];
    centre += mesh.vertices[v][0] / (box.dimension + 1);
  }
  element.corner[box.dimension + 1][box.dimension] = top;
  element.region = centre < box.length[0] / 2 ? 1 : 2;
  return element;
}

}  // namespace

PitchedElements pitch_elements(const PitchedBox& box, const DisplacementField& field) {
  std::mt19937 generator(box.seed);
  std::uniform_real_distribution<double> height(0.5 * box.tent_height, 1.5 * box.tent_height);
  const BoxMesh mesh = make_mesh(box, generator);
  const OrthonormalBasis basis(box.dimension + 1, box.degree);
  const Quadrature rule = simplex_quadrature(box.dimension + 1, 2 * box.degree);
  std::vector<double> time(mesh.vertices.size(), 0.0);
  PitchedElements result;
  for (;;) {
    const int vertex = static_cast<int>(std::min_element(time.begin(), time.end()) - time.begin());
    if (time[vertex] >= box.end) break;
    const double top = std::min(box.end, time[vertex] + height(generator));
    for (const auto& cell : mesh.cells) {
      if (std::find(cell.begin(), cell.end(), vertex) == cell.end()) continue;
      SpacetimeElement element = tent_element(box, mesh, time, cell, vertex, top);
      element.id = static_cast<std::int64_t>(result.elements.size());
      result.coefficients.push_back(project(box, basis, rule, element, field));
      result.elements.push_back(element);
    }
    time[vertex] = top;
  }
  // Only now do the coefficient vectors stay where they are.
  for (std::size_t i = 0; i < result.elements.size(); ++i) result.elements[i].coefficients = result.coefficients[i];
  return result;
}

}  // namespace tentpole
