#include "host/adaptive/grow_cracks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "host/front/point_location.hpp"
#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {
namespace {

/// Rounds that a trigger waits for an admissible edge.
constexpr int max_tries = 200;
/// A branch leaves the crack at this angle at least.
constexpr double branch_cosine = 0.866;  // 30 degrees
/// An existing edge is taken where its direction is off by this much at most; otherwise the opposite edge is cut.
constexpr double edge_cosine = 0.94;  // 20 degrees
/// Cuts keep this distance from the ends of an edge.
constexpr double smallest_fraction = 0.3;

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

/// Where a ray from a vertex leaves the star: the cell's opposite edge and the place on it.
struct RayExit {
  std::int32_t first, second;
  double fraction;  ///< from first to second
};

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
    if (alpha >= 0 && beta >= 0 && alpha + beta > 0) return RayExit{first, second, beta / (alpha + beta)};
  }
  return std::nullopt;
}

class CrackMaker {
 public:
  CrackMaker(AdaptiveState& state, Refinement& refinement) : state_(state), refinement_(refinement) {}

  /// Whether the trigger is done with.
  bool follow(const DefectTrigger& trigger) {
    std::int32_t cell = locate(mesh(), trigger.position);
    if (cell == none) return true;
    if (state_.has_refinement()) cell = refine_place(trigger, cell);
    if (cell == none) return false;
    return mesh().dimension() == 1 ? nucleate_vertex(trigger, cell) : make_edges(trigger, cell);
  }

 private:
  const FrontMesh& mesh() const { return state_.front.mesh(); }

  /// The cell at the trigger once it is small enough, or none.
  std::int32_t refine_place(const DefectTrigger& trigger, std::int32_t cell) {
    for (int depth = 0; depth < 40 && longest_edge(mesh().simplex(cell)) > 1.0001 * state_.limits.crack_size; ++depth) {
      const std::int64_t serial = mesh().cell(cell).serial;
      refinement_.split({cell, serial});
      if (mesh().is_alive_cell(cell) && mesh().cell(cell).serial == serial) return none;
      cell = locate(mesh(), trigger.position);
    }
    return cell;
  }

  std::int32_t nearest_vertex(const DefectTrigger& trigger, std::int32_t cell) const {
    const auto vertices = mesh().vertices(cell);
    return *std::ranges::min_element(
        vertices, {}, [&](std::int32_t vertex) { return distance(mesh().position(vertex), trigger.position); });
  }

  void count_nucleation(const DefectTrigger& trigger, std::int32_t vertex) {
    if (state_.counts.nucleations++ == 0) state_.first_nucleation = {mesh().time(vertex), trigger.position};
  }

  bool nucleate_vertex(const DefectTrigger& trigger, std::int32_t cell) {
    const std::int32_t vertex = nearest_vertex(trigger, cell);
    if (is_on_boundary(mesh(), vertex) || state_.front.crack_edge(vertex, vertex) != none) return true;
    state_.front.mark_crack(vertex, vertex);
    state_.follow_front();
    count_nucleation(trigger, vertex);
    return true;
  }

  bool make_edges(const DefectTrigger& trigger, std::int32_t cell) {
    std::int32_t tip = none, body = none;
    for (const std::int32_t vertex : mesh().vertices(cell)) {
      const std::size_t edges = state_.front.cracks().at(vertex).size();
      if (edges == 1 && !is_on_boundary(mesh(), vertex) && tip == none) tip = vertex;
      if (edges > 1 || (edges == 1 && tip != vertex)) body = vertex;
    }
    if (tip != none) return extend(trigger, tip);
    if (body != none) return branch(trigger, body);
    return nucleate(trigger, nearest_vertex(trigger, cell));
  }

  /// Direction of a surface with the n-th normal.
  static Point along(const DefectTrigger& trigger, int n) { return {-trigger.normal[n][1], trigger.normal[n][0], 0}; }

  /// Goes on from the tip into the half space ahead; of mirrored directions that which turns less.
  bool extend(const DefectTrigger& trigger, std::int32_t tip) {
    const auto& edge = state_.front.cracks().edge(state_.front.cracks().at(tip)[0]);
    const Point ahead = direction_between(mesh(), edge[0] == tip ? edge[1] : edge[0], tip);
    Point best{};
    double turn = -1;
    for (int n = 0; n < trigger.num_normals; ++n) {
      const Point way = along(trigger, n);
      const double cosine = dot(way, ahead);
      if (std::fabs(cosine) > turn) {
        turn = std::fabs(cosine);
        best = cosine < 0 ? Point{-way[0], -way[1], 0} : way;
      }
    }
    const bool made = add_edge(tip, best);
    if (made) ++state_.counts.extensions;
    return made;
  }

  /// Leaves the middle of a crack where the direction differs enough from all edges there. A surface nearly along the
  /// crack needs none of its own.
  bool branch(const DefectTrigger& trigger, std::int32_t vertex) {
    const auto edges = state_.front.cracks().at(vertex);
    if (edges.size() > 2) return true;
    Point best{};
    double smallest = 1;
    for (int n = 0; n < trigger.num_normals; ++n)
      for (const double sign : {1.0, -1.0}) {
        const Point way = along(trigger, n), signed_way{sign * way[0], sign * way[1], 0};
        double closest = -1;
        for (const std::int32_t index : edges) {
          const auto& edge = state_.front.cracks().edge(index);
          closest = std::max(closest,
                             dot(signed_way, direction_between(mesh(), vertex, edge[0] == vertex ? edge[1] : edge[0])));
        }
        if (closest < smallest) {
          smallest = closest;
          best = signed_way;
        }
      }
    if (smallest > branch_cosine) return true;
    const bool made = add_edge(vertex, best);
    if (made) ++state_.counts.branches;
    return made;
  }

  bool nucleate(const DefectTrigger& trigger, std::int32_t vertex) {
    const Point way = along(trigger, 0);
    const bool first = add_edge(vertex, way), second = add_edge(vertex, {-way[0], -way[1], 0});
    if (first || second) count_nucleation(trigger, vertex);
    return first || second;
  }

  /// One crack edge from a vertex in about this direction; false where none is admissible now or the ray leaves the
  /// domain.
  bool add_edge(std::int32_t vertex, const Point& direction) {
    const std::optional<RayExit> exit = ray_exit(mesh(), vertex, direction);
    if (!exit) return false;
    std::int32_t end = none;
    double best = edge_cosine;
    for (const std::int32_t candidate : {exit->first, exit->second})
      if (const double cosine = dot(direction_between(mesh(), vertex, candidate), direction); cosine > best) {
        best = cosine;
        end = candidate;
      }
    if (end == none) end = cut_or_nearest(*exit, vertex, direction);
    if (end == none || !is_free_edge(vertex, end)) return false;
    const bool joins = !state_.front.cracks().at(end).empty() || is_on_boundary(mesh(), end);
    state_.front.mark_crack(vertex, end);
    state_.follow_front();
    if (joins) ++state_.counts.coalescences;
    return true;
  }

  /// A new vertex on the opposite edge; where that would leave pieces shorter than half the least size of cells, the
  /// end of the edge that is nearest to the direction.
  std::int32_t cut_or_nearest(const RayExit& exit, std::int32_t vertex, const Point& direction) {
    const double fraction = std::clamp(exit.fraction, smallest_fraction, 1 - smallest_fraction);
    const double length = distance(mesh().position(exit.first), mesh().position(exit.second));
    if (std::min(fraction, 1 - fraction) * length >= state_.limits.min_size / 2)
      return refinement_.split_edge(exit.first, exit.second, fraction);
    const auto cosine = [&](std::int32_t end) { return dot(direction_between(mesh(), vertex, end), direction); };
    return cosine(exit.first) >= cosine(exit.second) ? exit.first : exit.second;
  }

  /// Inside the domain and no crack yet.
  bool is_free_edge(std::int32_t a, std::int32_t b) const {
    return mesh().cells_with(a, b).size == 2 && state_.front.crack_edge(a, b) == none;
  }

  AdaptiveState& state_;
  Refinement& refinement_;
};

}  // namespace

void grow_cracks(AdaptiveState& state, Refinement& refinement) {
  CrackMaker maker(state, refinement);
  std::vector<DefectTrigger> waiting;
  for (DefectTrigger& trigger : state.triggers)
    if (!maker.follow(trigger) && ++trigger.tries < max_tries) waiting.push_back(trigger);
  state.triggers = std::move(waiting);
}

}  // namespace tentpole
