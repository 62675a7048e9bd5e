#include "tests/host/front/random_operations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tentpole::testing {

namespace {

constexpr double no_end = 1e300;

double smallest_travel_time(const AdaptiveFront& front, int vertex, double causality) {
  double smallest = 1e300;
  for (const auto& [cell, corner] : front.mesh().star(vertex))
    smallest = std::min(smallest, front.slope_limit(front.mesh().cell(cell).region) / causality *
                                      altitude(front.mesh().simplex(cell), corner));
  return smallest;
}

void raise(AdaptiveFront& front, int vertex, double causality, OperationCounts& counts) {
  const double top = front.pole_top_time(vertex, no_end);
  const double rise = (top - front.time(vertex)) / smallest_travel_time(front, vertex, causality);
  counts.smallest_rise = std::min(counts.smallest_rise, rise);
  front.raise(vertex, top);
  ++counts.tents;
}

/// Towards a better place, or anywhere.
bool raise_inclined(AdaptiveFront& front, int vertex, std::mt19937_64& random, OperationCounts& counts) {
  auto target = front.smoothing_target(vertex);
  if (!target || draw_below(random, 2) == 0) {
    target = front.mesh().position(vertex);
    for (int axis = 0; axis < front.mesh().dimension(); ++axis) (*target)[axis] += 0.2 * (draw_unit(random) - 0.5);
  }
  const auto tent = front.plan_inclined_tent(vertex, *target, no_end);
  if (!tent) return false;
  front.raise_inclined(vertex, *tent);
  ++counts.inclined;
  return true;
}

void split(AdaptiveFront& front, std::mt19937_64& random, OperationCounts& counts) {
  const int cell = draw_cell(front.mesh(), random);
  if (draw_below(random, 3) > 0) {
    const SplitOutcome outcome = front.try_split(cell);
    counts.splits += static_cast<int>(outcome.cells.size());
    counts.refused += !outcome.is_done;
    return;
  }
  const auto corners = front.mesh().vertices(cell);
  const int first = draw_below(random, front.mesh().num_corners());
  const int second = (first + 1) % front.mesh().num_corners();
  const SplitOutcome outcome = front.split_edge(corners[first], corners[second], 0.25 + 0.5 * draw_unit(random));
  counts.edge_splits += outcome.is_done;
  counts.refused += !outcome.is_done;
}

bool flip(AdaptiveFront& front, std::mt19937_64& random, OperationCounts& counts) {
  const auto corners = front.mesh().vertices(draw_cell(front.mesh(), random));
  const int first = draw_below(random, front.mesh().num_corners());
  const auto plan = front.plan_flip(corners[first], corners[(first + 1) % front.mesh().num_corners()]);
  if (plan) front.commit(plan->exchange);
  counts.flips += plan.has_value();
  return plan.has_value();
}

}  // namespace

int draw_below(std::mt19937_64& random, int n) {
  return static_cast<int>(random() % static_cast<std::uint64_t>(n));
}

double draw_unit(std::mt19937_64& random) {
  return (static_cast<double>(random() >> 11) + 0.5) / 9007199254740992.0;
}

int draw_cell(const FrontMesh& mesh, std::mt19937_64& random) {
  int cell = draw_below(random, mesh.num_cell_slots());
  while (!mesh.is_alive_cell(cell)) cell = draw_below(random, mesh.num_cell_slots());
  return cell;
}

void random_operation(AdaptiveFront& front, std::mt19937_64& random, double causality, const OperationMix& mix,
                      OperationCounts& counts) {
  const double choice = mix.only_tents ? 0 : draw_unit(random);
  if (choice > 0.85 && front.mesh().num_cells() < mix.max_cells) return split(front, random, counts);
  if (choice > 0.75 && choice < 0.85 && flip(front, random, counts)) return;
  const std::vector<std::int32_t> minima = front.local_minima(no_end);
  const int vertex = minima[draw_below(random, static_cast<int>(minima.size()))];
  if (choice > 0.55 && choice < 0.75)
    if (const auto plan = front.plan_deletion(vertex, mix.deletion)) {
      front.commit(*plan);
      ++counts.deletions;
      return;
    }
  if (choice > 0.4 && choice < 0.55 && raise_inclined(front, vertex, random, counts)) return;
  raise(front, vertex, causality, counts);
}

void divide_into_regions(SpaceMesh& mesh, double x) {
  mesh.region_names = {"left", "right"};
  for (int cell = 0; cell < mesh.num_cells(); ++cell) {
    double centre = 0;
    for (int corner = 0; corner <= mesh.dimension; ++corner)
      centre += mesh.corner_position(cell, corner)[0] / (mesh.dimension + 1);
    mesh.cell_region[cell] = centre > x;
  }
}

void mark_random_cracks(AdaptiveFront& front, std::mt19937_64& random, int n) {
  const FrontMesh& mesh = front.mesh();
  for (int cell = 0; cell < mesh.num_cell_slots(); ++cell)
    for (int facet = 0; facet < mesh.num_corners(); ++facet) {
      if (!mesh.is_alive_cell(cell) || mesh.cell(cell).neighbor[facet] <= cell || draw_below(random, n) > 0) continue;
      const auto corners = mesh.vertices(cell);
      front.mark_crack(corners[facet == 0 ? 1 : 0], corners[mesh.dimension() == 1 ? 1 - facet : (facet == 2 ? 1 : 2)]);
    }
}

double smallest_angle(const FrontMesh& mesh) {
  double sine = 1;
  for (int cell = 0; cell < mesh.num_cell_slots(); ++cell)
    if (mesh.is_alive_cell(cell)) sine = std::min(sine, smallest_angle_sine(mesh.simplex(cell)));
  return std::asin(sine) * 180 / std::numbers::pi;
}

}  // namespace tentpole::testing
