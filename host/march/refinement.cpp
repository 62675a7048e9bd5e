#include "host/march/refinement.hpp"

#include <algorithm>
#include <array>

namespace tentpole {
namespace {

/// Barycentric coordinates in the parent of the corners of a part in their ascending order: the parent's, with the new
/// vertex in place of `dropped`.
CellPart part_of(const CellSplit& split, int dropped, int num_corners) {
  struct Corner {
    std::int32_t vertex;
    std::array<double, max_dimension + 1> barycentric{};
  };
  std::vector<Corner> corners(num_corners);
  for (int corner = 0; corner < num_corners; ++corner) {
    corners[corner].vertex = split.parent_vertex[corner];
    corners[corner].barycentric[corner] = 1;
  }
  corners[dropped].vertex = split.vertex;
  corners[dropped].barycentric = {};
  corners[dropped].barycentric[split.lower_corner] = 1 - split.fraction;
  corners[dropped].barycentric[split.higher_corner] = split.fraction;
  std::ranges::sort(corners, {}, &Corner::vertex);
  CellPart part{};
  for (int corner = 0; corner < num_corners; ++corner) part[corner] = corners[corner].barycentric;
  return part;
}

}  // namespace

/// Whether a part has not been cut again by the closure that made it.
bool Refinement::is_current(const CellSplit& split, int side) const {
  const FrontMesh& mesh = state_.front.mesh();
  return mesh.is_alive_cell(split.child[side]) && mesh.cell(split.child[side]).serial == split.child_serial[side];
}

bool Refinement::split(const FootprintCell& cell) {
  const FrontMesh& mesh = state_.front.mesh();
  if (!mesh.is_alive_cell(cell.cell) || mesh.cell(cell.cell).serial != cell.serial) return true;
  const SplitOutcome outcome = state_.front.try_split(cell.cell);
  follow(outcome);
  return outcome.is_done;
}

std::int32_t Refinement::split_edge(std::int32_t a, std::int32_t b, double fraction) {
  const SplitOutcome outcome = state_.front.split_edge(a, b, fraction);
  follow(outcome);
  return outcome.is_done ? outcome.cells.front().vertex : none;
}

void Refinement::follow(const SplitOutcome& outcome) {
  state_.follow_front();
  // The cells on both sides of a cut edge go at once, and a part of one may take the slot of the other: read both
  // first.
  for (std::size_t first = 0, last = 0; first < outcome.cells.size(); first = last) {
    std::array<std::int32_t, 2> source{}, facet{};
    while (last < outcome.cells.size() && outcome.cells[last].vertex == outcome.cells[first].vertex) {
      source[last - first] = state_.sources.slot[outcome.cells[last].parent];
      facet[last - first] = state_.sources.facet[outcome.cells[last].parent];
      ++last;
    }
    for (std::size_t i = first; i < last; ++i) follow_cell(outcome.cells[i], source[i - first], facet[i - first]);
  }
  for (const EdgeSplit& split : outcome.crack_edges) follow_crack(split);
  state_.counts.splits += static_cast<std::int64_t>(outcome.cells.size());
}

void Refinement::follow_cell(const CellSplit& split, std::int32_t source, std::int32_t facet) {
  state_.memory[split.vertex] = {};
  for (int side = 0; side < 2; ++side)
    if (is_current(split, side)) state_.measure(split.child[side]);
  if (source == none) {
    for (const std::int32_t child : split.child) state_.sources.slot[child] = none;
    return;
  }
  const int dimension = state_.front.mesh().dimension();
  const std::int32_t made = source < std::ssize(generation_of_slot_) ? generation_of_slot_[source] : none;
  const std::size_t generation = made == none ? 0 : made + 1;
  if (generations_.size() <= generation) generations_.resize(generation + 1);
  for (int side = 0; side < 2; ++side) {
    // Child 0 keeps the lower corner: the new vertex takes the place of the higher one.
    const int dropped = side == 0 ? split.higher_corner : split.lower_corner;
    TransplantRequest request = cell_part_request(dimension, facet, part_of(split, dropped, dimension + 1));
    request.source_slot = source;
    request.target_slot = state_.books.store.acquire();
    generations_[generation].push_back(request);
    if (std::ssize(generation_of_slot_) <= request.target_slot)
      generation_of_slot_.resize(request.target_slot + 1, none);
    generation_of_slot_[request.target_slot] = static_cast<std::int32_t>(generation);
    state_.sources.slot[split.child[side]] = request.target_slot;
    state_.sources.facet[split.child[side]] = dimension + 1;
  }
  state_.books.store.release(source);
}

void Refinement::follow_crack(const EdgeSplit& split) {
  const CrackEdgeState parent = state_.crack_state[split.crack_edge];
  if (split.lower == split.higher) return;
  const double f = split.fraction;
  const bool after_lower = split.lower < split.vertex, before_higher = split.vertex < split.higher;
  state_.crack_state[split.half[0]] = after_lower ? restrict_to_part(parent, 0, f) : restrict_to_part(parent, f, 0);
  state_.crack_state[split.half[1]] = before_higher ? restrict_to_part(parent, f, 1) : restrict_to_part(parent, 1, f);
  for (const std::int32_t half : split.half) state_.crack_mode[half] = state_.crack_mode[split.crack_edge];
}

void Refinement::flush() {
  for (const std::vector<TransplantRequest>& generation : generations_)
    state_.books.runner.transplant(generation, state_.books.store.num_slots());
  generations_.clear();
  std::ranges::fill(generation_of_slot_, none);
  state_.books.store.end_batch();
}

}  // namespace tentpole
