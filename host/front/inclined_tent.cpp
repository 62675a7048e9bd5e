#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "host/front/adaptive_front.hpp"
#include "host/front/progress_rule.hpp"
#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int max_tries = 8;  ///< the first height and seven lower ones
constexpr double height_reduction = 0.7;
constexpr double smallest_area = 0.1;  ///< of a new cell, relative to the old one
/// The pole's top lies above every old plane by these parts of the longest edge / c and of the pole's height.
constexpr double clearance_of_edge = 1e-3, clearance_of_height = 0.1;
/// On an interface the facets at the pole must be vertical to this precision.
constexpr double vertical_tolerance = 1e-13;
constexpr double damping = 0.5, smallest_gain = 1.02;  ///< of smoothing

/// Distance of `position` from the line through `a` and `b`.
double distance_from_line(const Point& position, const Point& a, const Point& b) {
  const Point line = difference(b, a), arm = difference(position, a);
  return std::abs(arm[0] * line[1] - arm[1] * line[0]) / std::sqrt(dot(line, line));
}

/// Tip of the equilateral triangle on the facet opposite `corner`, on that corner's side.
Point equilateral_tip(const FrontSimplex& cell, int corner) {
  const Point &first = cell.position[(corner + 1) % 3], &second = cell.position[(corner + 2) % 3];
  const Point edge = difference(second, first), arm = difference(cell.position[corner], first);
  const double height = (edge[0] * arm[1] - edge[1] * arm[0] > 0 ? 1 : -1) * std::sqrt(0.75);
  return {(first[0] + second[0]) / 2 - height * edge[1], (first[1] + second[1]) / 2 + height * edge[0], 0};
}

/// Mean of some points, the components of D dimensions.
Point mean(int dimension, std::span<const Point> points) {
  Point sum{};
  for (const Point& point : points)
    for (int axis = 0; axis < dimension; ++axis) sum[axis] += point[axis];
  for (double& coordinate : sum) coordinate /= static_cast<double>(points.size());
  return sum;
}

/// Undamped aims of smoothing: the mean of the neighbours (those on the line of a line vertex) and, for inner vertices
/// of D = 2, that of the equilateral tips.
std::vector<Point> better_positions(const FrontMesh& mesh, int vertex) {
  std::vector<Point> points;
  if (const auto ends = line_neighbors(mesh, vertex))
    for (const std::int32_t end : *ends) points.push_back(mesh.position(end));
  else
    for (const std::int32_t end : mesh.neighbors(vertex)) points.push_back(mesh.position(end));
  std::vector<Point> aims{mean(mesh.dimension(), points)};
  if (mesh.dimension() == 1 || mesh.kind(vertex) == VertexKind::line) return aims;
  points.clear();
  for (const auto& [cell, corner] : mesh.star(vertex)) points.push_back(equilateral_tip(mesh.simplex(cell), corner));
  aims.push_back(mean(mesh.dimension(), points));
  return aims;
}

}  // namespace

double AdaptiveFront::star_quality(int vertex, const Point& position) const {
  double worst = infinity, longest = 0;
  for (const auto& [cell, corner] : mesh_.star(vertex)) {
    FrontSimplex simplex = mesh_.simplex(cell);
    const double old_measure = signed_measure(simplex);
    simplex.position[corner] = position;
    if (old_measure * signed_measure(simplex) <= 0) return 0;
    if (mesh_.dimension() == 2 && old_measure < 0) std::swap(simplex.position[0], simplex.position[1]);
    const double quality = mesh_.dimension() == 1 ? std::abs(signed_measure(simplex)) : 1 / shape_defect(simplex);
    worst = std::min(worst, quality);
    longest = std::max(longest, quality);
  }
  return mesh_.dimension() == 1 ? worst / longest : worst;
}

std::optional<Point> AdaptiveFront::movable_target(int vertex, const Point& target) const {
  if (mesh_.kind(vertex) == VertexKind::corner || !cracks_.at(vertex).empty()) return std::nullopt;
  const auto ends = line_neighbors(mesh_, vertex);
  if (!ends) return target;
  const Point& start = mesh_.position(vertex);
  const Point line = difference(mesh_.position((*ends)[1]), mesh_.position((*ends)[0]));
  const double shift = dot(difference(target, start), line) / dot(line, line);
  return Point{start[0] + shift * line[0], start[1] + shift * line[1], 0};
}

std::optional<Point> AdaptiveFront::smoothing_target(int vertex) const {
  const Point& start = mesh_.position(vertex);
  if (!movable_target(vertex, start)) return std::nullopt;
  std::optional<Point> best;
  double best_quality = smallest_gain * star_quality(vertex, start);
  for (const Point& aim : better_positions(mesh_, vertex)) {
    Point damped{};
    for (int axis = 0; axis < mesh_.dimension(); ++axis)
      damped[axis] = start[axis] + damping * (aim[axis] - start[axis]);
    const Point target = *movable_target(vertex, damped);
    const double quality = star_quality(vertex, target);
    if (quality < best_quality) continue;
    best = target;
    best_quality = quality;
  }
  return best;
}

bool AdaptiveFront::is_admissible(int vertex, const InclinedTent& tent) const {
  const double height = tent.time - time(vertex);
  if (const auto ends = line_neighbors(mesh_, vertex))
    for (const std::int32_t end : *ends) {
      const double offset = distance_from_line(tent.position, mesh_.position(end), mesh_.position(vertex));
      const EdgeCells cells = mesh_.cells_with(vertex, end);
      if (cells.size == 2 && offset > vertical_tolerance * height) return false;
    }
  for (const auto& [cell, corner] : mesh_.star(vertex)) {
    FrontSimplex simplex = mesh_.simplex(cell);
    const double slope_limit = slope_limit_of(cell), old_measure = signed_measure(simplex);
    const double clearance = tent.time - time_at(simplex, tent.position);
    const double edge_travel_time = longest_edge(simplex) * slope_limit / rules_.causality;
    if (clearance < std::max(clearance_of_edge * edge_travel_time, clearance_of_height * height)) return false;
    simplex.position[corner] = tent.position;
    simplex.time[corner] = tent.time;
    if (signed_measure(simplex) / old_measure < smallest_area || !may_be_on_front(simplex, slope_limit)) return false;
  }
  return true;
}

std::optional<InclinedTent> AdaptiveFront::plan_inclined_tent(int vertex, const Point& target, double end_time) const {
  const auto aim = movable_target(vertex, target);
  if (!aim) return std::nullopt;
  const Point& start = mesh_.position(vertex);
  const Point shift = difference(*aim, start);
  const double bottom = time(vertex), height = pole_top_time(vertex, end_time) - bottom;
  double slowest = infinity;
  for (const auto& [cell, corner] : mesh_.star(vertex))
    slowest = std::min(slowest, rules_.causality / slope_limit_of(cell));
  const double length = std::sqrt(dot(shift, shift)), reach = rules_.max_pole_speed * slowest * height;
  if (!(length > 0) || !(reach > 0)) return std::nullopt;
  const double part = std::min(1.0, reach / length);
  double reduction = 1;
  for (int attempt = 0; attempt < max_tries; ++attempt, reduction *= height_reduction) {
    const double step = reduction * part;
    const InclinedTent tent{{start[0] + step * shift[0], start[1] + step * shift[1], 0}, bottom + reduction * height};
    if (is_admissible(vertex, tent)) return tent;
  }
  return std::nullopt;
}

void AdaptiveFront::raise_inclined(int vertex, const InclinedTent& tent) {
  assert(is_admissible(vertex, tent) && "the tent was planned on this front");
  mesh_.set_position(vertex, tent.position);
  raise(vertex, tent.time);
}

}  // namespace tentpole
