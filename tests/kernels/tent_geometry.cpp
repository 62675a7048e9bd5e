#include "tests/kernels/tent_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace tentpole {
namespace {

double uniform(double low, double high, std::mt19937& generator) {
  return std::uniform_real_distribution<double>(low, high)(generator);
}

/// Angles in the range with the sum 360 degrees (ring) or less than 330 (chain), by rejection.
std::vector<double> random_angles(bool closed, double low, double high, std::mt19937& generator) {
  if (closed && (3 * low > 360 || high < 60)) throw std::invalid_argument("fan_star: no ring has such angles");
  for (int attempt = 0; attempt < 100000; ++attempt) {
    const int count = std::uniform_int_distribution<int>(closed ? 3 : 1, closed ? 8 : 5)(generator);
    std::vector<double> angles(count);
    for (double& angle : angles) angle = uniform(low, high, generator);
    const double sum = std::accumulate(angles.begin(), angles.end(), 0.0);
    if (!closed && sum < 330) return angles;
    for (double& angle : angles) angle *= 360 / sum;
    const auto [least, greatest] = std::minmax_element(angles.begin(), angles.end());
    if (closed && *least >= low && *greatest <= high) return angles;
  }
  throw std::invalid_argument("fan_star: no such angles found");
}

using Gradient = std::array<double, max_dimension>;

double dot(const Gradient& a, const Gradient& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Gradient of the linear function with these vertex values on a cell, by elimination with pivoting.
Gradient cell_gradient(const TentGeometry& tent, int cell, const std::vector<double>& values) {
  const int D = tent.dimension;
  const auto& corners = tent.cells[cell];
  double system[max_dimension][max_dimension + 1];
  for (int row = 0; row < D; ++row) {
    for (int j = 0; j < D; ++j) system[row][j] = tent.position[corners[row + 1]][j] - tent.position[corners[0]][j];
    system[row][D] = values[corners[row + 1]] - values[corners[0]];
  }
  for (int column = 0; column < D; ++column) {
    int pivot = column;
    for (int row = column; row < D; ++row)
      if (std::abs(system[row][column]) > std::abs(system[pivot][column])) pivot = row;
    for (int j = 0; j <= D; ++j) std::swap(system[column][j], system[pivot][j]);
    for (int row = 0; row < D; ++row) {
      if (row == column) continue;
      const double factor = system[row][column] / system[column][column];
      for (int j = column; j <= D; ++j) system[row][j] -= factor * system[column][j];
    }
  }
  Gradient gradient{};
  for (int j = 0; j < D; ++j) gradient[j] = system[j][D] / system[j][j];
  return gradient;
}

}  // namespace

void shuffle_vertices(TentGeometry& tent, std::mt19937& generator) {
  const int num_vertices = static_cast<int>(tent.position.size());
  std::vector<int> id(num_vertices);
  std::iota(id.begin(), id.end(), 0);
  std::shuffle(id.begin(), id.end(), generator);
  auto position = tent.position;
  for (int vertex = 0; vertex < num_vertices; ++vertex) position[id[vertex]] = tent.position[vertex];
  tent.position = position;
  for (auto& cell : tent.cells) {
    for (int c = 0; c <= tent.dimension; ++c) cell[c] = id[cell[c]];
    std::sort(cell.begin(), cell.begin() + tent.dimension + 1);
  }
  tent.pole = id[tent.pole];
  tent.time.assign(num_vertices, 0.0);
}

TentGeometry line_star(bool at_boundary, std::mt19937& generator) {
  TentGeometry tent;
  tent.dimension = 1;
  tent.position = {{0.0}, {uniform(0.4, 1.5, generator)}, {-uniform(0.4, 1.5, generator)}};
  tent.cells = {{0, 1}, {0, 2}};
  if (at_boundary) {
    tent.position.pop_back();
    tent.cells.pop_back();
  }
  shuffle_vertices(tent, generator);
  return tent;
}

TentGeometry fan_star(bool at_boundary, double min_angle_degrees, double max_angle_degrees, std::mt19937& generator) {
  TentGeometry tent;
  tent.dimension = 2;
  tent.position = {{uniform(-0.1, 0.1, generator), uniform(-0.1, 0.1, generator)}};
  const auto angles = random_angles(!at_boundary, min_angle_degrees, max_angle_degrees, generator);
  const int num_cells = static_cast<int>(angles.size()), num_spokes = at_boundary ? num_cells + 1 : num_cells;
  double direction = uniform(0, 360, generator);
  for (int spoke = 0; spoke < num_spokes; ++spoke) {
    const double radius = uniform(0.6, 1.4, generator), radians = direction * std::numbers::pi / 180;
    tent.position.push_back(
        {tent.position[0][0] + radius * std::cos(radians), tent.position[0][1] + radius * std::sin(radians)});
    if (spoke < num_cells) {
      tent.cells.push_back({0, 1 + spoke, 1 + (spoke + 1) % num_spokes});
      direction += angles[spoke];
    }
  }
  shuffle_vertices(tent, generator);
  return tent;
}

TentGeometry cube_star(bool at_boundary, double flatness, std::mt19937& generator) {
  TentGeometry tent;
  tent.dimension = 3;
  tent.position = {{0, 0, 0}};
  for (int corner = 0; corner < 8; ++corner)
    tent.position.push_back({corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5});
  std::vector<int> faces(6);
  std::iota(faces.begin(), faces.end(), 0);
  std::shuffle(faces.begin(), faces.end(), generator);
  if (at_boundary) faces.resize(std::uniform_int_distribution<int>(1, 5)(generator));
  for (const int face : faces) {
    const int axis = face / 2, side = face % 2, first = 1 << ((axis + 1) % 3), second = 1 << ((axis + 2) % 3);
    const int centre = static_cast<int>(tent.position.size()), base = 1 + (side << axis);
    tent.position.push_back({});
    tent.position.back()[axis] = side ? 0.5 : -0.5;
    const std::array<int, 4> around{base, base + first, base + first + second, base + second};
    for (int edge = 0; edge < 4; ++edge) tent.cells.push_back({0, centre, around[edge], around[(edge + 1) % 4]});
  }
  for (auto& vertex : tent.position) {
    for (double& coordinate : vertex) coordinate += uniform(-0.1, 0.1, generator);
    vertex[2] *= flatness;
  }
  shuffle_vertices(tent, generator);
  return tent;
}

TentGeometry random_star(int dimension, bool at_boundary, const StarShape& shape, std::mt19937& generator) {
  if (dimension == 1) return line_star(at_boundary, generator);
  if (dimension == 2) return fan_star(at_boundary, shape.min_angle_degrees, shape.max_angle_degrees, generator);
  return cube_star(at_boundary, shape.flatness, generator);
}

void raise_tent(TentGeometry& tent, const std::vector<double>& wave_speed, double steepness, double height_fraction,
                std::mt19937& generator) {
  const int num_cells = static_cast<int>(tent.cells.size());
  const Gradient slope{uniform(-1, 1, generator), uniform(-1, 1, generator), uniform(-1, 1, generator)};
  const double roughness = uniform(0, 0.5, generator);
  for (std::size_t vertex = 0; vertex < tent.time.size(); ++vertex)
    tent.time[vertex] = dot(slope, tent.position[vertex]) + roughness * uniform(-1, 1, generator);
  double steepest = 0;
  for (int cell = 0; cell < num_cells; ++cell) {
    const Gradient gradient = cell_gradient(tent, cell, tent.time);
    steepest = std::max(steepest, wave_speed[cell] * std::sqrt(dot(gradient, gradient)));
  }
  for (double& time : tent.time) time *= steepness / steepest;

  // |g + h grad lambda|^2 = (0.95 / c)^2 for the rise h, the smallest over the cells.
  std::vector<double> hat(tent.time.size(), 0.0);
  hat[tent.pole] = 1;
  double limit = std::numeric_limits<double>::infinity();
  for (int cell = 0; cell < num_cells; ++cell) {
    const Gradient g = cell_gradient(tent, cell, tent.time), rise = cell_gradient(tent, cell, hat);
    const double a = dot(rise, rise), b = dot(g, rise), bound = 0.95 / wave_speed[cell];
    limit = std::min(limit, (-b + std::sqrt(b * b + a * (bound * bound - dot(g, g)))) / a);
  }
  tent.top_time = tent.time[tent.pole] + height_fraction * limit;
}

}  // namespace tentpole
