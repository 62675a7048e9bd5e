#include <algorithm>
#include <cmath>

#include "host/front/adaptive_front.hpp"
#include "host/front/progress_rule.hpp"
#include "host/mesh/insertion_sort.hpp"

namespace tentpole {

namespace {

constexpr double smallest_clearance = 1e-3;  ///< of the new planes above the old edge, as part of the longest edge / c
constexpr double smallest_gain = 1e-6;       ///< of the smallest angle's sine
constexpr double smallest_relative_area = 1e-6;  ///< twice the area over the longest edge squared

std::int32_t opposite_vertex(const FrontCell& cell, int a, int b) {
  return *std::find_if(cell.vertex.begin(), cell.vertex.end(), [&](int vertex) { return vertex != a && vertex != b; });
}

bool is_flat(const FrontSimplex& cell) {
  const double longest = longest_edge(cell);
  return 2 * std::abs(signed_measure(cell)) < smallest_relative_area * longest * longest;
}

}  // namespace

std::optional<FlipPlan> AdaptiveFront::plan_flip(int a, int b) const {
  if (mesh_.dimension() != 2 || cracks_.find(a, b) != none) return std::nullopt;
  const EdgeCells old = mesh_.cells_with(a, b);
  if (old.size != 2) return std::nullopt;
  const FrontCell &first = mesh_.cell(old.cell[0]), &second = mesh_.cell(old.cell[1]);
  if (first.region != second.region) return std::nullopt;
  const std::array<std::int32_t, 2> edge{std::min(a, b), std::max(a, b)};
  std::array<std::int32_t, 2> diagonal{opposite_vertex(first, a, b), opposite_vertex(second, a, b)};
  insertion_sort(diagonal, 2);
  const double slope_limit = slope_limit_[first.region];
  SpacetimeSimplex element{{edge[0], edge[1], diagonal[0], diagonal[1]}, first.region};
  insertion_sort(element.vertex, 4);
  FlipPlan plan{{footprint_of(old.cell), {}, {element}, {}}, diagonal, 0};
  double new_sine = 1;
  std::array<double, 2> orientation{};
  for (int side = 0; side < 2; ++side) {
    const FrontSimplex cell = mesh_.simplex({diagonal[0], diagonal[1], edge[side]});
    orientation[side] = signed_measure(cell);
    if (is_flat(cell) || !may_be_on_front(cell, slope_limit)) return std::nullopt;
    const int opposite = edge[1 - side];
    const double clearance = time_at(cell, mesh_.position(opposite)) - time(opposite);
    if (clearance < smallest_clearance * longest_edge(cell) * slope_limit / rules_.causality) return std::nullopt;
    new_sine = std::min(new_sine, smallest_angle_sine(cell));
    FrontVertices corners{diagonal[0], diagonal[1], edge[side]};
    insertion_sort(corners, 3);
    plan.exchange.above.push_back(
        {corners, first.region, std::max(first.generation, second.generation), mesh_.longest_edge_corner(corners)});
  }
  const bool is_convex = orientation[0] * orientation[1] < 0;
  const double old_sine =
      std::min(smallest_angle_sine(mesh_.simplex(old.cell[0])), smallest_angle_sine(mesh_.simplex(old.cell[1])));
  plan.angle_gain = new_sine - old_sine;
  if (!is_convex || plan.angle_gain < smallest_gain) return std::nullopt;
  return plan;
}

}  // namespace tentpole
