#include "tests/host/march/planned_patch.hpp"

#include <gtest/gtest.h>

namespace tentpole::testing {

PatchPlan planned_tent(const AdaptiveState& state, std::int32_t vertex, double height) {
  const FrontMesh& mesh = state.front.mesh();
  PatchPlan plan;
  plan.vertex = vertex;
  for (const CellCorner& entry : mesh.star(vertex))
    plan.exchange.below.push_back({entry.cell, mesh.cell(entry.cell).serial});
  plan.top = {mesh.position(vertex), mesh.time(vertex) + height};
  return plan;
}

PatchPlan planned_deletion(AdaptiveState& state, std::int32_t vertex) {
  constexpr double no_end = 1e9;
  PatchPlan plan;
  plan.operation = PatchOperation::deletion;
  plan.vertex = vertex;
  for (int round = 0; round < 100; ++round) {
    if (state.front.is_local_minimum(vertex))
      if (std::optional<CellExchange> exchange = state.front.plan_deletion(vertex)) {
        plan.exchange = *exchange;
        return plan;
      }
    for (const std::int32_t minimum : state.front.local_minima(no_end))
      state.front.raise(minimum, state.front.pole_top_time(minimum, no_end));
  }
  ADD_FAILURE() << "vertex " << vertex << " never may go";
  return plan;
}

std::int32_t busiest_vertex(const FrontMesh& mesh, VertexKind kind) {
  std::int32_t found = none;
  for (int vertex = 0; vertex < mesh.num_vertices(); ++vertex)
    if (mesh.kind(vertex) == kind && (found == none || mesh.star(vertex).size() > mesh.star(found).size()))
      found = vertex;
  return found;
}

}  // namespace tentpole::testing
