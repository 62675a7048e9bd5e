#include "host/march/plan_patch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <utility>

namespace tentpole {
namespace {

/// Cells with a smaller angle are worth a flip or an inclined pole.
constexpr double poor_angle_sine = 0.5;  // 30 degrees

/// Where a patch had less than this part of the tolerance its cells are not refined next, so poles need not be gentle.
constexpr double still_dissipation = 1e-3;

/// Part of the tolerated height that a pole keeps after its patch failed.
double shortened(double bottom, double top, int halvings) {
  return bottom + (top - bottom) * std::ldexp(1.0, -halvings);
}

Footprint star_footprint(const FrontMesh& mesh, std::int32_t vertex) {
  Footprint footprint;
  for (const CellCorner& entry : mesh.star(vertex)) footprint.push_back({entry.cell, mesh.cell(entry.cell).serial});
  return footprint;
}

double smallest_angle_sine_of_star(const FrontMesh& mesh, std::int32_t vertex) {
  double smallest = 1;
  for (const CellCorner& entry : mesh.star(vertex))
    smallest = std::min(smallest, smallest_angle_sine(mesh.simplex(entry.cell)));
  return smallest;
}

/// Longest edge that coarsening may make round a vertex: near cracks cells stay small.
double coarse_limit(const AdaptiveState& state, std::int32_t vertex) {
  return is_near_active_crack(state, vertex) ? state.limits.crack_size : state.limits.max_size;
}

std::optional<FlipPlan> best_flip(const AdaptiveFront& front, std::int32_t vertex) {
  std::optional<FlipPlan> best;
  for (const std::int32_t other : front.mesh().neighbors(vertex)) {
    std::optional<FlipPlan> plan = front.plan_flip(vertex, other);
    if (plan && (!best || plan->angle_gain > best->angle_gain)) best = std::move(plan);
  }
  return best;
}

[[noreturn]] void fail_flat(const AdaptiveState& state, std::int32_t vertex) {
  const Scaling& scaling = state.books.simulation.scaling;
  const Point& position = state.front.mesh().position(vertex);
  char text[300];
  std::snprintf(
      text, sizeof text,
      "tent at (%.6g, %.6g) m, t = %.6g s: its height, at most %.3g s where damage grows, is lost in the rounding "
      "of the time. Raise \"fracture.relaxation_time\" or \"fracture.max_damage_step\".",
      position[0] * scaling.length, position[1] * scaling.length, state.front.time(vertex) * scaling.time(),
      state.limits.max_pole_height * scaling.time());
  throw std::runtime_error(text);
}

double tent_top(const AdaptiveState& state, std::int32_t vertex) {
  const double bottom = state.front.time(vertex);
  const bool is_still =
      state.memory[vertex].dissipation_ratio < still_dissipation && !is_near_active_crack(state, vertex);
  double top = state.front.pole_top_time(vertex, state.books.simulation.scaled_end_time(),
                                         is_still ? Pitch::full : Pitch::gentle);
  if (touches_active_crack(state, vertex)) top = std::min(top, bottom + state.limits.max_pole_height);
  if (state.memory[vertex].halvings > 0) top = shortened(bottom, top, state.memory[vertex].halvings);
  if (!(top > bottom)) fail_flat(state, vertex);
  return top;
}

}  // namespace

PatchPlan plan_patch(const AdaptiveState& state, std::int32_t vertex) {
  const FrontMesh& mesh = state.front.mesh();
  PatchPlan plan;
  plan.vertex = vertex;
  if (state.memory[vertex].dissipation_ratio < state.books.simulation.settings.adaptivity.coarsening) {
    DeletionLimits limits;
    limits.longest_edge = coarse_limit(state, vertex);
    if (std::optional<CellExchange> deletion = state.front.plan_deletion(vertex, limits)) {
      plan.operation = PatchOperation::deletion;
      plan.exchange = std::move(*deletion);
      return plan;
    }
  }
  const bool improves = state.books.simulation.settings.front.smoothing && mesh.dimension() == 2 &&
                        !state.memory[vertex].keeps_shape && state.front.cracks().at(vertex).empty() &&
                        smallest_angle_sine_of_star(mesh, vertex) < poor_angle_sine;
  if (improves) {
    if (std::optional<FlipPlan> flip = best_flip(state.front, vertex)) {
      plan.operation = PatchOperation::flip;
      plan.exchange = std::move(flip->exchange);
      return plan;
    }
  }
  plan.exchange.below = star_footprint(mesh, vertex);
  if (improves)
    if (const std::optional<Point> target = state.front.smoothing_target(vertex))
      if (const auto tent = state.front.plan_inclined_tent(vertex, *target, state.books.simulation.scaled_end_time())) {
        plan.operation = PatchOperation::inclined_tent;
        plan.top = *tent;
        return plan;
      }
  plan.top = {mesh.position(vertex), tent_top(state, vertex)};
  return plan;
}

}  // namespace tentpole
