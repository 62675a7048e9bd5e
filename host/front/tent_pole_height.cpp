#include "host/front/tent_pole_height.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "host/front/edge_slope_amplification.hpp"
#include "host/mesh/printed_number.hpp"
#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double obtuse_margin = 0.3;  ///< eps of rule B

using Corners = std::array<Point, SpaceMesh::max_corners>;

/// Largest |tau_i - tau_j| / (g |e|) along the edges (i, j) of one cell, symmetric.
using EdgeFactors = std::array<std::array<double, SpaceMesh::max_corners>, SpaceMesh::max_corners>;

/// Sine of the angle at corner `at` if it is obtuse, else 1.
double obtuse_sine(const Corners& corners, int at) {
  const Point a = difference(corners[(at + 1) % 3], corners[at]), b = difference(corners[(at + 2) % 3], corners[at]);
  const double cosine = dot(a, b) / std::sqrt(dot(a, a) * dot(b, b));
  return cosine < 0 ? std::sqrt(std::max(0.0, 1 - cosine * cosine)) : 1;
}

EdgeFactors edge_factors(int dimension, const Corners& corners) {
  EdgeFactors factors{};
  if (dimension == 2) {
    std::array<double, 3> sine{};
    for (int i = 0; i < 3; ++i) sine[i] = obtuse_sine(corners, i);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) factors[i][j] = (1 - obtuse_margin) * std::min(sine[i], sine[j]);
  } else {
    const double factor = 1 / edge_slope_amplification(dimension, corners);
    for (auto& row : factors) row.fill(factor);
  }
  return factors;
}

Corners cell_corners(const SpaceMesh& mesh, int cell) {
  Corners corners{};
  for (int i = 0; i <= mesh.dimension; ++i) corners[i] = mesh.corner_position(cell, i);
  return corners;
}

/// Rule B's first limit: the upper root of |grad tau| = g for the time of corner `top` of a triangle.
double causal_limit(const SpaceMesh& mesh, CellCorner top, double slope_limit, std::span<const double> times) {
  const int first = top.corner == 0 ? 1 : 0, second = top.corner == 2 ? 1 : 2;
  const Point base = mesh.corner_position(top.cell, first);
  const Point edge = difference(mesh.corner_position(top.cell, second), base);
  const Point arm = difference(mesh.corner_position(top.cell, top.corner), base);
  const double time_first = times[mesh.cells[top.cell][first]], time_second = times[mesh.cells[top.cell][second]];
  const double length = std::sqrt(edge[0] * edge[0] + edge[1] * edge[1]);
  const double foot = (arm[0] * edge[0] + arm[1] * edge[1]) / length;
  const double altitude = std::abs(arm[0] * edge[1] - arm[1] * edge[0]) / length;
  const double slope = (time_second - time_first) / length;
  return time_first + slope * foot + altitude * std::sqrt(std::max(0.0, slope_limit * slope_limit - slope * slope));
}

}  // namespace

TentPoleLimits::TentPoleLimits(const SpaceMesh& mesh, std::span<const double> cell_wave_speed, double causality) {
  if (!(causality > 0 && causality <= 1))
    throw std::invalid_argument("causality is " + printed(causality) + "; it must lie in (0, 1].");
  if (static_cast<int>(cell_wave_speed.size()) != mesh.num_cells())
    throw std::invalid_argument("wave speeds of " + std::to_string(cell_wave_speed.size()) + " cells for a mesh of " +
                                std::to_string(mesh.num_cells()));
  for (std::size_t cell = 0; cell < cell_wave_speed.size(); ++cell) {
    if (!(cell_wave_speed[cell] > 0 && cell_wave_speed[cell] < infinity))
      throw std::invalid_argument("cell " + std::to_string(cell) + ": wave speed is " + printed(cell_wave_speed[cell]) +
                                  "; it must be positive and finite.");
    slope_limit_.push_back(causality / cell_wave_speed[cell]);
  }
  collect_edge_limits(mesh);
}

void TentPoleLimits::collect_edge_limits(const SpaceMesh& mesh) {
  std::vector<EdgeFactors> factors;
  factors.reserve(mesh.cells.size());
  for (int cell = 0; cell < mesh.num_cells(); ++cell)
    factors.push_back(edge_factors(mesh.dimension, cell_corners(mesh, cell)));
  struct Limit {
    std::int32_t vertex;
    double value;
    auto operator<=>(const Limit&) const = default;
  };
  std::vector<Limit> around;
  offset_.push_back(0);
  for (int vertex = 0; vertex < mesh.num_vertices(); ++vertex) {
    around.clear();
    for (const auto& [cell, corner] : mesh.star(vertex))
      for (int other = 0; other <= mesh.dimension; ++other) {
        if (other == corner) continue;
        const double length = distance(mesh.corner_position(cell, corner), mesh.corner_position(cell, other));
        around.push_back({mesh.cells[cell][other], slope_limit_[cell] * length * factors[cell][corner][other]});
      }
    std::sort(around.begin(), around.end());  // the smallest limit of each neighbour comes first
    for (const Limit& limit : around) {
      const bool is_known = static_cast<int>(neighbor_.size()) > offset_.back() && neighbor_.back() == limit.vertex;
      if (is_known) continue;
      neighbor_.push_back(limit.vertex);
      edge_limit_.push_back(limit.value);
    }
    offset_.push_back(static_cast<std::int32_t>(neighbor_.size()));
  }
}

double TentPoleLimits::latest_time(const SpaceMesh& mesh, int vertex, std::span<const double> times) const {
  double latest = infinity;
  for (int entry = offset_[vertex]; entry < offset_[vertex + 1]; ++entry)
    latest = std::min(latest, times[neighbor_[entry]] + edge_limit_[entry]);
  if (mesh.dimension == 2)
    for (const CellCorner& top : mesh.star(vertex))
      latest = std::min(latest, causal_limit(mesh, top, slope_limit_[top.cell], times));
  return latest;
}

}  // namespace tentpole
