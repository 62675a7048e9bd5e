#include "host/march/require_sound_state.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "common/binary_stream.hpp"
#include "host/march/judge_patch.hpp"

namespace tentpole {
namespace {

void require(bool holds, const std::string& fault) {
  if (!holds) throw std::runtime_error(fault);
}

std::string nth(const char* name, std::size_t index) {
  return std::string(name) + " " + std::to_string(index);
}

void require_cracks(const AdaptiveState& state) {
  const std::size_t num_edges = state.front.cracks().size();
  // A new edge gets its state when the march goes on.
  require(state.crack_state.size() <= num_edges && state.crack_mode.size() == state.crack_state.size(),
          "there are " + std::to_string(num_edges) + " crack edges, states of " +
              std::to_string(state.crack_state.size()) + " and modes of " + std::to_string(state.crack_mode.size()));
  for (std::size_t edge = 0; edge < state.crack_state.size(); ++edge) {
    const CrackEdgeState& crack = state.crack_state[edge];
    require(crack.num_points == state.num_points(),
            nth("crack edge", edge) + " has " + std::to_string(crack.num_points) + " points");
    for (int point = 0; point < crack.num_points; ++point)
      require(crack.damage[point] >= 0 && crack.damage[point] <= 1 && std::isfinite(crack.gap[point]),
              nth("crack edge", edge) + " has a damage that is not in [0, 1] or a gap that is not finite");
    require(!std::isnan(crack.effective_traction), nth("crack edge", edge) + " has no effective traction");
    const CrackMode mode = state.crack_mode[edge];
    require(mode == CrackMode::open || mode == CrackMode::stick || mode == CrackMode::slip,
            nth("crack edge", edge) + " has the unknown mode " + std::to_string(static_cast<std::int64_t>(mode)));
  }
}

void require_growth(const AdaptiveState& state) {
  for (std::size_t i = 0; i < state.triggers.size(); ++i) {
    const DefectTrigger& trigger = state.triggers[i];
    require(all_finite(trigger.position) && all_finite(trigger.normal[0]) && all_finite(trigger.normal[1]) &&
                trigger.num_normals >= 0 && trigger.num_normals <= 2,
            nth("defect that gave way", i) + " has numbers that are not finite, or a wrong number of normals");
  }
  for (std::size_t i = 0; i < state.growths.size(); ++i) {
    const CrackGrowth& growth = state.growths[i];
    require(
        growth.vertex >= 0 && growth.vertex < state.front.mesh().num_vertex_slots() &&
            state.front.mesh().is_alive_vertex(growth.vertex),
        nth("growing surface", i) + " begins at vertex " + std::to_string(growth.vertex) + ", which does not exist");
    require(all_finite(growth.direction) && std::isfinite(growth.remaining),
            nth("growing surface", i) + " has numbers that are not finite");
  }
}

void require_counts(const AdaptiveState& state) {
  const AdaptiveCounts& c = state.counts;
  for (const std::int64_t count :
       {c.rejected, c.min_size_hits, c.refused, c.splits, c.deletions, c.flips, c.inclined, c.nucleations, c.extensions,
        c.branches, c.coalescences, c.cells_min, c.cells_max, state.num_tested})
    require(count >= 0, "a count is " + std::to_string(count));
  require(std::isfinite(state.first_nucleation.time) && all_finite(state.first_nucleation.position),
          "place or time of the first nucleation is not finite");
  require(!std::isnan(state.edges.shortest) && std::isfinite(state.edges.longest), "a length of edges is not finite");
}

}  // namespace

void require_sound_state(const AdaptiveState& state) {
  const int num_vertices = state.front.mesh().num_vertex_slots();
  require(
      std::ssize(state.memory) == num_vertices,
      "there are " + std::to_string(num_vertices) + " vertices and memories of " + std::to_string(state.memory.size()));
  for (std::size_t vertex = 0; vertex < state.memory.size(); ++vertex)
    require(state.memory[vertex].halvings <= max_halvings,
            nth("vertex", vertex) + " has " + std::to_string(state.memory[vertex].halvings) + " halvings");
  for (std::size_t i = 0; i < state.pending.size(); ++i)
    require(
        state.pending[i].cell >= 0 && state.pending[i].cell < state.front.mesh().num_cell_slots(),
        nth("pending split", i) + " is of cell " + std::to_string(state.pending[i].cell) + ", which does not exist");
  require_cracks(state);
  require_growth(state);
  require_counts(state);
}

}  // namespace tentpole
