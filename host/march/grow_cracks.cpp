#include "host/march/grow_cracks.hpp"

#include <algorithm>
#include <cmath>

#include "host/front/point_location.hpp"
#include "host/march/crack_growth.hpp"
#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {
namespace {

/// A branch leaves the crack at this angle at least.
constexpr double branch_cosine = 0.866;  // 30 degrees

Point opposite(const Point& direction) {
  return {-direction[0], -direction[1], 0};
}

/// Direction of a surface with the n-th normal.
Point along(const DefectTrigger& trigger, int n) {
  return {-trigger.normal[n][1], trigger.normal[n][0], 0};
}

class TriggerFollower {
 public:
  TriggerFollower(AdaptiveState& state, Refinement& refinement)
      : state_(state), refinement_(refinement), grower_(state, refinement) {}

  /// Whether the trigger is done with.
  bool follow(const DefectTrigger& trigger) {
    const std::optional<std::int32_t> cell =
        refinement_.refine_for_crack([&] { return locate(mesh(), trigger.position); });
    if (!cell) return false;
    if (*cell == none) return true;
    return mesh().dimension() == 1 ? nucleate_vertex(trigger, *cell) : make_surface(trigger, *cell);
  }

  /// A surface whose tip another one has reached meanwhile ends there.
  void finish_growths() {
    std::vector<CrackGrowth> unfinished;
    for (CrackGrowth& growth : state_.growths)
      if (is_tip(growth.vertex) && !grower_.grow(growth)) unfinished.push_back(growth);
    state_.growths = std::move(unfinished);
  }

 private:
  const FrontMesh& mesh() const { return state_.front.mesh(); }

  bool is_tip(std::int32_t vertex) const {
    return state_.front.cracks().at(vertex).size() == 1 && !is_on_boundary(mesh(), vertex);
  }

  double distance_to(const DefectTrigger& trigger, std::int32_t vertex) const {
    return distance(mesh().position(vertex), trigger.position);
  }

  /// The vertices of the cell and, from them on, all within reach of the trigger; the nearest first.
  std::vector<std::int32_t> vertices_near(const DefectTrigger& trigger, std::int32_t cell) const {
    const auto corners = mesh().vertices(cell);
    std::vector<std::int32_t> found(corners.begin(), corners.end());
    for (std::size_t next = 0; next < found.size(); ++next)
      for (const std::int32_t other : mesh().neighbors(found[next]))
        if (distance_to(trigger, other) <= state_.limits.growth_length &&
            std::ranges::find(found, other) == found.end())
          found.push_back(other);
    std::ranges::sort(found, {}, [&](std::int32_t vertex) { return std::pair(distance_to(trigger, vertex), vertex); });
    return found;
  }

  void count_nucleation(const DefectTrigger& trigger, std::int32_t vertex) {
    if (state_.counts.nucleations == 0) state_.first_nucleation = {mesh().time(vertex), trigger.position};
    state_.count(CrackEvent::nucleation, vertex);
  }

  bool nucleate_vertex(const DefectTrigger& trigger, std::int32_t cell) {
    const std::int32_t vertex = *std::ranges::min_element(
        mesh().vertices(cell), {}, [&](std::int32_t corner) { return distance_to(trigger, corner); });
    if (is_on_boundary(mesh(), vertex) || state_.front.crack_edge(vertex, vertex) != none) return true;
    state_.front.mark_crack(vertex, vertex);
    state_.follow_front();
    count_nucleation(trigger, vertex);
    return true;
  }

  bool is_growing(std::int32_t vertex) const {
    return std::ranges::find(state_.growths, vertex, &CrackGrowth::vertex) != state_.growths.end();
  }

  bool make_surface(const DefectTrigger& trigger, std::int32_t cell) {
    const std::vector<std::int32_t> near = vertices_near(trigger, cell);
    const auto num_edges = [&](std::int32_t vertex) { return state_.front.cracks().at(vertex).size(); };
    const auto tip = std::ranges::find_if(near, [&](std::int32_t vertex) { return is_tip(vertex); });
    if (tip != near.end()) return extend(trigger, *tip);
    const auto body = std::ranges::find_if(near, [&](std::int32_t vertex) { return num_edges(vertex) > 0; });
    if (body != near.end()) return branch(trigger, *body);
    return nucleate(trigger, near.front());
  }

  /// Whether the trigger is done with: its surface has begun, or there can be none.
  bool start(const CrackGrowth& growth, CrackEvent event) {
    const CrackGrower::Start outcome = grower_.start(growth);
    if (outcome == CrackGrower::Start::begun) state_.count(event, growth.vertex);
    return outcome != CrackGrower::Start::must_wait;
  }

  /// Goes on from the tip into the half space ahead; of mirrored directions that which turns less.
  bool extend(const DefectTrigger& trigger, std::int32_t tip) {
    if (is_growing(tip)) return false;
    const auto& edge = state_.front.cracks().edge(state_.front.cracks().at(tip)[0]);
    const Point ahead = direction_between(mesh(), edge[0] == tip ? edge[1] : edge[0], tip);
    Point best{};
    double turn = -1;
    for (int n = 0; n < trigger.num_normals; ++n) {
      const Point way = along(trigger, n);
      const double cosine = dot(way, ahead);
      if (std::fabs(cosine) > turn) {
        turn = std::fabs(cosine);
        best = cosine < 0 ? opposite(way) : way;
      }
    }
    return start({tip, best, state_.limits.growth_length}, CrackEvent::extension);
  }

  /// Leaves the middle of a crack where the direction differs enough from all edges there. A surface nearly along the
  /// crack needs none of its own.
  bool branch(const DefectTrigger& trigger, std::int32_t vertex) {
    const auto edges = state_.front.cracks().at(vertex);
    if (edges.size() > 2) return true;
    Point best{};
    double smallest = 1;
    for (int n = 0; n < trigger.num_normals; ++n)
      for (const Point& way : {along(trigger, n), opposite(along(trigger, n))}) {
        double closest = -1;
        for (const std::int32_t index : edges) {
          const auto& edge = state_.front.cracks().edge(index);
          const std::int32_t other = edge[0] == vertex ? edge[1] : edge[0];
          closest = std::max(closest, dot(way, direction_between(mesh(), vertex, other)));
        }
        if (closest < smallest) {
          smallest = closest;
          best = way;
        }
      }
    if (smallest > branch_cosine) return true;
    return start({vertex, best, state_.limits.growth_length}, CrackEvent::branch);
  }

  bool nucleate(const DefectTrigger& trigger, std::int32_t vertex) {
    const Point way = along(trigger, 0);
    const double length = state_.limits.growth_length;
    CrackGrower::Start arm = grower_.start({vertex, way, length});
    if (arm == CrackGrower::Start::begun) {
      CrackGrowth other{vertex, opposite(way), length};
      if (!grower_.grow(other)) state_.growths.push_back(other);
    } else if (arm == CrackGrower::Start::impossible) {
      arm = grower_.start({vertex, opposite(way), length});
    }
    if (arm == CrackGrower::Start::begun) count_nucleation(trigger, vertex);
    return arm != CrackGrower::Start::must_wait;
  }

  AdaptiveState& state_;
  Refinement& refinement_;
  CrackGrower grower_;
};

}  // namespace

void grow_cracks(AdaptiveState& state, Refinement& refinement) {
  TriggerFollower follower(state, refinement);
  follower.finish_growths();
  std::vector<DefectTrigger> waiting;
  for (const DefectTrigger& trigger : state.triggers)
    if (!follower.follow(trigger)) waiting.push_back(trigger);
  state.triggers = std::move(waiting);
}

}  // namespace tentpole
