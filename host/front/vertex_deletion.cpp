#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "host/front/adaptive_front.hpp"
#include "host/front/polygon_triangulation.hpp"
#include "host/front/progress_rule.hpp"
#include "host/front/vertex_ring.hpp"
#include "host/mesh/insertion_sort.hpp"
#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t max_ring_size = 8;
/// New planes pass above the vertex by this part of the longest edge / c, so that no element is a sliver.
constexpr double smallest_clearance = 1e-3;
/// Above an interface the facet between the two sides must be vertical to this precision.
constexpr double vertical_tolerance = 1e-13;

std::vector<std::int32_t> cells_round(const FrontMesh& mesh, int vertex) {
  std::vector<std::int32_t> cells;
  for (const auto& [cell, corner] : mesh.star(vertex)) cells.push_back(cell);
  return cells;
}

/// Boundary index of the facets at a line vertex, or none on an interface.
std::int32_t line_boundary(const FrontMesh& mesh, int vertex) {
  for (const auto& [cell, corner] : mesh.star(vertex))
    for (int facet = 0; facet < mesh.num_corners(); ++facet)
      if (facet != corner && mesh.cell(cell).boundary[facet] != none) return mesh.cell(cell).boundary[facet];
  return none;
}

/// The polygons of D = 2; the one interval between the neighbours for D = 1.
std::vector<RingPart> hole_of(const FrontMesh& mesh, int vertex) {
  if (mesh.dimension() == 2) return vertex_ring(mesh, vertex);
  return {{mesh.neighbors(vertex), mesh.cell(mesh.star(vertex)[0].cell).region}};
}

SpacetimeSimplex cone(std::int32_t vertex, const FrontVertices& cell, int num_corners, std::int32_t region) {
  SpacetimeSimplex element{{none, none, none, none}, region};
  std::copy_n(cell.begin(), num_corners, element.vertex.begin());
  element.vertex[num_corners] = vertex;
  insertion_sort(element.vertex, num_corners + 1);
  return element;
}

}  // namespace

double AdaptiveFront::deletion_cost(int vertex, int region, const FrontVertices& corners,
                                    const DeletionLimits& limits) const {
  const FrontSimplex cell = mesh_.simplex(corners);
  const double cost = shape_defect(cell), longest = longest_edge(cell);
  if (cost == infinity || longest > limits.longest_edge) return infinity;
  if (smallest_angle_sine(cell) < std::sin(limits.smallest_angle * std::numbers::pi / 180)) return infinity;
  if (!may_be_on_front(cell, slope_limit_[region])) return infinity;
  const double clearance = time_at(cell, mesh_.position(vertex)) - time(vertex);
  return clearance < smallest_clearance * longest * slope_limit_[region] / rules_.causality ? infinity : cost;
}

bool AdaptiveFront::merged_line_is_admissible(int vertex, std::int32_t a, std::int32_t b) const {
  if (line_boundary(mesh_, vertex) != none) return true;
  const Point line = difference(mesh_.position(b), mesh_.position(a));
  const Point arm = difference(mesh_.position(vertex), mesh_.position(a));
  const double length = std::sqrt(dot(line, line)), part = dot(arm, line) / dot(line, line);
  const double offset = std::abs(arm[0] * line[1] - arm[1] * line[0]) / length;
  const double clearance = time(a) + part * (time(b) - time(a)) - time(vertex);
  return offset <= vertical_tolerance * clearance;
}

std::optional<CellExchange> AdaptiveFront::plan_deletion(int vertex, const DeletionLimits& limits) const {
  if (mesh_.kind(vertex) == VertexKind::corner || !cracks_.at(vertex).empty()) return std::nullopt;
  const std::vector<RingPart> hole = hole_of(mesh_, vertex);
  std::size_t ring_size = 0;
  for (const RingPart& part : hole) ring_size += part.vertices.size();
  if (ring_size > max_ring_size) return std::nullopt;
  CellExchange plan{.below = footprint_of(cells_round(mesh_, vertex)), .above = {}, .between = {}, .boundary = {}};
  if (const auto ends = line_neighbors(mesh_, vertex)) {
    if (!merged_line_is_admissible(vertex, (*ends)[0], (*ends)[1])) return std::nullopt;
    if (const std::int32_t boundary = line_boundary(mesh_, vertex); boundary != none)
      plan.boundary.push_back({*ends, boundary});
  }
  int generation = std::numeric_limits<int>::max();
  for (const FootprintCell& entry : plan.below) generation = std::min(generation, mesh_.cell(entry.cell).generation);
  for (const RingPart& part : hole) {
    const auto corners_of = [&](const PolygonTriangle& triangle) {
      return FrontVertices{part.vertices[triangle[0]], part.vertices[triangle[1]], part.vertices[triangle[2]]};
    };
    std::vector<FrontVertices> cells;
    if (mesh_.dimension() == 1) {
      const FrontVertices merged{part.vertices[0], part.vertices[1], none};
      if (deletion_cost(vertex, part.region, merged, limits) < infinity) cells.push_back(merged);
    } else {
      const auto cost = [&](const PolygonTriangle& triangle) {
        return deletion_cost(vertex, part.region, corners_of(triangle), limits);
      };
      for (const PolygonTriangle& triangle : best_triangulation(static_cast<int>(part.vertices.size()), cost))
        cells.push_back(corners_of(triangle));
    }
    if (cells.empty()) return std::nullopt;
    for (FrontVertices& corners : cells) {
      insertion_sort(corners, mesh_.num_corners());
      plan.above.push_back({corners, part.region, std::max(generation - 1, 0), mesh_.longest_edge_corner(corners)});
      plan.between.push_back(cone(vertex, corners, mesh_.num_corners(), part.region));
    }
  }
  return plan;
}

}  // namespace tentpole
