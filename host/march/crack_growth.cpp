#include "host/march/crack_growth.hpp"

#include <algorithm>
#include <cmath>

#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {
namespace {

/// An existing edge is taken where its direction is off by this much at most; otherwise the opposite edge is cut.
constexpr double edge_cosine = 0.94;  // 20 degrees
/// Cuts keep this distance from the ends of an edge.
constexpr double smallest_fraction = 0.3;

}  // namespace

/// Where a ray from a vertex leaves the star: through which cell, its opposite edge and the place on it.
struct RayExit {
  std::int32_t cell;
  std::int32_t first, second;
  double fraction;  ///< from first to second
};

namespace {

/// The cell that a ray from a vertex enters, or nothing where it leaves the domain.
std::optional<RayExit> ray_exit(const FrontMesh& mesh, std::int32_t vertex, const Point& direction) {
  for (const CellCorner& entry : mesh.star(vertex)) {
    const auto vertices = mesh.vertices(entry.cell);
    const std::int32_t first = vertices[entry.corner == 0 ? 1 : 0], second = vertices[entry.corner == 2 ? 1 : 2];
    const Point a = difference(mesh.position(first), mesh.position(vertex));
    const Point b = difference(mesh.position(second), mesh.position(vertex));
    // direction = alpha a + beta b, both not negative, in this cell
    const double determinant = a[0] * b[1] - a[1] * b[0];
    const double alpha = (direction[0] * b[1] - direction[1] * b[0]) / determinant;
    const double beta = (a[0] * direction[1] - a[1] * direction[0]) / determinant;
    if (alpha >= 0 && beta >= 0 && alpha + beta > 0) return RayExit{entry.cell, first, second, beta / (alpha + beta)};
  }
  return std::nullopt;
}

}  // namespace

Point direction_between(const FrontMesh& mesh, std::int32_t from, std::int32_t to) {
  const Point step = difference(mesh.position(to), mesh.position(from));
  const double length = std::sqrt(dot(step, step));
  return {step[0] / length, step[1] / length, 0};
}

bool is_on_boundary(const FrontMesh& mesh, std::int32_t vertex) {
  for (const CellCorner& entry : mesh.star(vertex)) {
    const FrontCell& cell = mesh.cell(entry.cell);
    for (int facet = 0; facet <= mesh.dimension(); ++facet)
      if (cell.vertex[facet] != vertex && cell.boundary[facet] != none) return true;
    if (mesh.dimension() == 1 && cell.boundary[1 - entry.corner] != none) return true;
  }
  return false;
}

bool CrackGrower::grow(CrackGrowth& growth) {
  while (true) {
    const double before = growth.remaining;
    const Outcome outcome = add_edge(growth);
    if (outcome != Outcome::made) return outcome == Outcome::ended;
    const double edge = before - growth.remaining;
    if (growth.remaining < edge / 2) return true;
  }
}

CrackGrower::Start CrackGrower::start(CrackGrowth growth) {
  const std::int32_t vertex = growth.vertex;
  const bool is_complete = grow(growth);
  if (growth.vertex == vertex) return is_complete ? Start::impossible : Start::must_wait;
  if (!is_complete) state_.growths.push_back(growth);
  return Start::begun;
}

/// A new vertex on the opposite edge; where that would leave pieces shorter than half the least size of cells, the end
/// of the edge that is nearest to the direction. None where the cut was refused.
std::int32_t CrackGrower::cut_or_nearest(const RayExit& exit, const CrackGrowth& growth) {
  const double fraction = std::clamp(exit.fraction, smallest_fraction, 1 - smallest_fraction);
  const double length = distance(mesh().position(exit.first), mesh().position(exit.second));
  if (std::min(fraction, 1 - fraction) * length >= state_.limits.min_size / 2)
    return refinement_.split_edge(exit.first, exit.second, fraction);
  const auto cosine = [&](std::int32_t end) {
    return dot(direction_between(mesh(), growth.vertex, end), growth.direction);
  };
  return cosine(exit.first) >= cosine(exit.second) ? exit.first : exit.second;
}

CrackGrower::Outcome CrackGrower::add_edge(CrackGrowth& growth) {
  std::optional<RayExit> exit;
  const std::optional<std::int32_t> cell = refinement_.refine_for_crack([&] {
    exit = ray_exit(mesh(), growth.vertex, growth.direction);
    return exit ? exit->cell : none;
  });
  if (!cell) return Outcome::refused;
  if (!exit) return Outcome::ended;
  std::int32_t end = none;
  double best = edge_cosine;
  for (const std::int32_t candidate : {exit->first, exit->second})
    if (const double cosine = dot(direction_between(mesh(), growth.vertex, candidate), growth.direction);
        cosine > best) {
      best = cosine;
      end = candidate;
    }
  if (end == none) end = cut_or_nearest(*exit, growth);
  if (end == none) return Outcome::refused;
  const bool is_inside = mesh().cells_with(growth.vertex, end).size == 2;
  if (!is_inside || state_.front.crack_edge(growth.vertex, end) != none) return Outcome::ended;
  const bool joins = !state_.front.cracks().at(end).empty() || is_on_boundary(mesh(), end);
  state_.front.mark_crack(growth.vertex, end);
  state_.follow_front();
  growth.remaining -= distance(mesh().position(growth.vertex), mesh().position(end));
  growth.vertex = end;
  if (!joins) return Outcome::made;
  state_.count(CrackEvent::coalescence, end);
  return Outcome::ended;
}

}  // namespace tentpole
