#pragma once

#include "host/march/plan_patch.hpp"

namespace tentpole::testing {

/// A vertical tent at any vertex, whatever the front allows; `height` scaled.
PatchPlan planned_tent(const AdaptiveState& state, std::int32_t vertex, double height);

/// Pitches tents round the vertex, without solving them, until it may be deleted. Fails the test where it never may.
PatchPlan planned_deletion(AdaptiveState& state, std::int32_t vertex);

/// The vertex of a kind that has the most cells.
std::int32_t busiest_vertex(const FrontMesh& mesh, VertexKind kind);

}  // namespace tentpole::testing
