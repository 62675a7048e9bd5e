#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include "host/books/run_books.hpp"
#include "host/fracture/crack_edge_state.hpp"
#include "host/front/adaptive_front.hpp"
#include "host/march/batch_builder.hpp"
#include "host/march/defect_trigger.hpp"
#include "host/mesh/simplex_geometry.hpp"
#include "host/output/crack_series.hpp"

namespace tentpole {

/// What an adaptive run counts beside patches and energies.
struct AdaptiveCounts {
  std::int64_t rejected = 0;
  std::int64_t min_size_hits = 0;  ///< elements above tolerance whose cell has the least size
  std::int64_t refused = 0;        ///< patches above tolerance that were accepted because no split was admissible
  std::int64_t splits = 0, deletions = 0, flips = 0, inclined = 0;
  std::int64_t nucleations = 0, extensions = 0, branches = 0, coalescences = 0;
  std::int64_t cells_min = 0, cells_max = 0;
};
static_assert(sizeof(AdaptiveCounts) == 13 * sizeof(std::int64_t), "checkpoints hold its bytes");

/// Shortest and longest edge that the front ever had.
struct EdgeRange {
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0;
};

/// Where and when the first defect made a crack, once counts.nucleations > 0; scaled.
struct FirstNucleation {
  double time = 0;  ///< of the front there
  Point position{};
};

/// Limits of the case in scaled units.
struct AdaptiveLimits {
  double tolerance = 0;        ///< dissipation of one element
  double min_size = 0;         ///< cells whose longest edge is at most this are not refined
  double max_size = 0;         ///< coarsening makes no longer edge
  double crack_size = 0;       ///< longest edge of cells at a crack whose damage grows, at least min_size
  double growth_length = 0;    ///< of the surface that a defect adds to a crack tip or to each side of itself
  double max_pole_height = 0;  ///< of vertices on such a crack: damage changes by at most max_damage_step
  FractureLaw law{};           ///< of all cracks
};

/// What a vertex remembers from patch to patch.
struct VertexMemory {
  float dissipation_ratio =
      std::numeric_limits<float>::infinity();  ///< largest of its last tent's elements / tolerance
  std::uint8_t keeps_shape = 0;  ///< its last deletion, flip or inclined tent was rejected: the next is a plain tent
  std::uint8_t halvings = 0;     ///< of the next pole's height, after patches that failed or stayed above tolerance
};

/// A cell whose refinement was refused and is tried again after later tents.
struct PendingSplit {
  std::int32_t cell;
  std::int64_t serial;
};

/// Everything that an adaptive march changes.
struct AdaptiveState {
  RunBooks& books;
  AdaptiveFront front;
  CellSources sources{};                      ///< [cell slot of the front]
  std::vector<CrackEdgeState> crack_state{};  ///< [crack edge], gap scaled
  std::vector<CrackMode> crack_mode{};        ///< [crack edge]
  std::vector<VertexMemory> memory{};         ///< [vertex slot]
  std::vector<PendingSplit> pending{};
  std::vector<DefectTrigger> triggers{};  ///< defects that have given way and wait for their crack
  std::vector<CrackGrowth> growths{};     ///< surfaces that wait for their next edge
  std::set<DefectId> spent{};             ///< defects of the field that made a crack or wait for one
  FirstNucleation first_nucleation{};
  std::int64_t num_tested = 0;  ///< cells tested by the sampled model
  AdaptiveCounts counts{};
  EdgeRange edges{};
  AdaptiveLimits limits{};

  int num_points() const { return front.mesh().dimension() == 1 ? 1 : books.simulation.degree() + 1; }
  bool has_refinement() const { return books.simulation.settings.adaptivity.enabled; }
  bool has_fracture() const { return books.simulation.settings.fracture.enabled; }

  /// Counts what happens to cracks at a vertex, at the time of the front there.
  void count(CrackEvent event, std::int32_t vertex) {
    std::int64_t* const counter[] = {&counts.nucleations, &counts.extensions, &counts.branches, &counts.coalescences};
    ++*counter[static_cast<int>(event)];
    books.history.add_event(event, books.simulation.time_in_seconds(front.mesh().time(vertex)));
  }

  /// Takes note of a new cell.
  void measure(std::int32_t cell) {
    const FrontSimplex simplex = front.mesh().simplex(cell);
    for (int i = 0; i <= simplex.dimension; ++i)
      for (int j = 0; j < i; ++j) {
        const double length = distance(simplex.position[i], simplex.position[j]);
        edges.shortest = std::min(edges.shortest, length);
        edges.longest = std::max(edges.longest, length);
      }
  }

  /// Sizes the arrays to the slots of the front.
  void follow_front() {
    sources.slot.resize(front.mesh().num_cell_slots(), none);
    sources.facet.resize(front.mesh().num_cell_slots(), 0);
    memory.resize(front.mesh().num_vertex_slots());
    while (static_cast<int>(crack_state.size()) < front.cracks().size()) {
      crack_state.push_back(uniform_crack_edge(num_points(), 0));
      crack_mode.push_back(CrackMode::open);
    }
  }
};

/// Whether a cell is larger than those at cracks whose damage grows should be.
inline bool is_too_large_for_crack(const AdaptiveState& state, std::int32_t cell) {
  return state.has_refinement() && longest_edge(state.front.mesh().simplex(cell)) > 1.0001 * state.limits.crack_size;
}

/// Whether damage grows, or is about to, on a crack edge at this vertex.
inline bool touches_active_crack(const AdaptiveState& state, int vertex) {
  for (const std::int32_t edge : state.front.cracks().at(vertex))
    if (is_active(state.crack_state[edge], state.limits.law)) return true;
  return false;
}

/// Whether that is so at a corner of the cells round this vertex.
inline bool is_near_active_crack(const AdaptiveState& state, int vertex) {
  const FrontMesh& mesh = state.front.mesh();
  for (const CellCorner& entry : mesh.star(vertex))
    for (const std::int32_t corner : mesh.vertices(entry.cell))
      if (touches_active_crack(state, corner)) return true;
  return false;
}

}  // namespace tentpole
