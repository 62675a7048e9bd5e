#include <algorithm>
#include <stdexcept>
#include <string>

#include "host/front/adaptive_front.hpp"
#include "host/front/progress_rule.hpp"
#include "host/mesh/insertion_sort.hpp"
#include "host/mesh/printed_number.hpp"

namespace tentpole {

/// An edge and where it is cut.
struct AdaptiveFront::EdgeCut {
  std::int32_t lower, higher;  ///< ends, ascending
  double fraction;             ///< from lower to higher
  Point position;
  double time;
  EdgeCells cells;
};

namespace {

/// The vertices of a cell with one of them replaced, ascending.
FrontVertices with_vertex(FrontVertices vertices, int dimension, int corner, std::int32_t vertex) {
  vertices[corner] = vertex;
  insertion_sort(vertices, dimension + 1);
  return vertices;
}

}  // namespace

AdaptiveFront::EdgeCut AdaptiveFront::edge_cut(int a, int b, double fraction) const {
  EdgeCut cut{std::min(a, b), std::max(a, b), a < b ? fraction : 1 - fraction, {}, 0, mesh_.cells_with(a, b)};
  const Point &from = mesh_.position(cut.lower), &to = mesh_.position(cut.higher);
  for (int axis = 0; axis < mesh_.dimension(); ++axis)
    cut.position[axis] = from[axis] + cut.fraction * (to[axis] - from[axis]);
  cut.time = time(cut.lower) + cut.fraction * (time(cut.higher) - time(cut.lower));
  return cut;
}

bool AdaptiveFront::is_admissible(const EdgeCut& cut) const {
  for (int side = 0; side < cut.cells.size; ++side) {
    const int cell = cut.cells.cell[side];
    for (const std::int32_t replaced : {cut.lower, cut.higher}) {
      FrontSimplex child = mesh_.simplex(cell);
      const int corner = mesh_.corner_of(cell, replaced);
      child.position[corner] = cut.position;
      child.time[corner] = cut.time;
      if (!may_be_on_front(child, slope_limit_of(cell))) return false;
    }
  }
  return true;
}

void AdaptiveFront::carry_out(const EdgeCut& cut, SplitOutcome& outcome) {
  const int dimension = mesh_.dimension();
  const std::span<const std::int32_t> parents(cut.cells.cell.data(), static_cast<std::size_t>(cut.cells.size));
  VertexKind kind = VertexKind::interior;
  std::int32_t boundary = none;
  if (dimension == 2) {
    const int facet = 3 - mesh_.corner_of(parents[0], cut.lower) -
                      mesh_.corner_of(parents[0], cut.higher);  // opposite the third corner
    if (mesh_.is_protected(parents[0], facet)) kind = VertexKind::line;
    boundary = mesh_.cell(parents[0]).boundary[facet];
  }
  const std::int32_t vertex = mesh_.add_vertex(cut.position, cut.time, kind);
  std::vector<NewFrontCell> children;
  const std::size_t first_record = outcome.cells.size();
  for (const std::int32_t parent : parents) {
    const FrontCell& cell = mesh_.cell(parent);
    const int lower = mesh_.corner_of(parent, cut.lower), higher = mesh_.corner_of(parent, cut.higher);
    outcome.cells.push_back({parent, cell.serial, cell.vertex, lower, higher, cut.fraction, vertex, {}, {}});
    for (const int replaced : {higher, lower}) {
      const FrontVertices corners = with_vertex(cell.vertex, dimension, replaced, vertex);
      const auto newest = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
      children.push_back(
          {corners, cell.region, cell.generation + 1, static_cast<std::uint8_t>(dimension == 2 ? newest : 0)});
    }
  }
  std::vector<NewBoundaryFacet> halves;
  if (boundary != none) halves = {{{cut.lower, vertex}, boundary}, {{vertex, cut.higher}, boundary}};
  const std::vector<std::int32_t> ids = replace(parents, children, halves);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    outcome.cells[first_record + i / 2].child[i % 2] = ids[i];
    outcome.cells[first_record + i / 2].child_serial[i % 2] = mesh_.cell(ids[i]).serial;
  }
  const std::int32_t crack_edge = cracks_.find(cut.lower, cut.higher);
  if (crack_edge != none)
    outcome.crack_edges.push_back(
        {cut.lower, cut.higher, vertex, cut.fraction, crack_edge, cracks_.split(crack_edge, vertex)});
}

SplitOutcome AdaptiveFront::split_edge(int a, int b, double fraction) {
  if (!(fraction > 0 && fraction < 1))
    throw std::invalid_argument("an edge cannot be cut at the fraction " + printed(fraction));
  const EdgeCut cut = edge_cut(a, b, fraction);
  if (a == b || cut.cells.size == 0)
    throw std::invalid_argument("vertices " + std::to_string(a) + " and " + std::to_string(b) + " share no edge");
  SplitOutcome outcome;
  if (!is_admissible(cut)) return outcome;
  carry_out(cut, outcome);
  outcome.is_done = true;
  return outcome;
}

std::int32_t AdaptiveFront::across_refinement_edge(int cell) const {
  return mesh_.cell(cell).neighbor[mesh_.cell(cell).refinement_corner];
}

SplitOutcome AdaptiveFront::try_split(int wanted) {
  const FrontCell& cell = mesh_.cell(wanted);
  if (mesh_.dimension() == 1) return split_edge(cell.vertex[0], cell.vertex[1], 0.5);
  SplitOutcome outcome;
  // Each cell of the chain waits for the next, which lies across its refinement edge and has another one.
  Footprint chain{{wanted, cell.serial}};
  while (!chain.empty()) {
    const std::int32_t current = chain.back().cell, other = across_refinement_edge(current);
    if (other != none && across_refinement_edge(other) != current) {
      const bool is_cycle =
          std::any_of(chain.begin(), chain.end(), [&](const FootprintCell& entry) { return entry.cell == other; });
      if (is_cycle) {
        // After deletions and flips refinement edges may point round a vertex. The last cell then takes the edge that
        // the one before it waits for.
        const std::int32_t previous = chain[chain.size() - 2].cell;
        const FrontCell& waiting = mesh_.cell(previous);
        mesh_.set_refinement_corner(current, waiting.neighbor_facet[waiting.refinement_corner]);
      } else {
        chain.push_back({other, mesh_.cell(other).serial});
      }
      continue;
    }
    const FrontCell& bisected = mesh_.cell(current);
    const int corner = bisected.refinement_corner;
    const EdgeCut cut = edge_cut(bisected.vertex[(corner + 1) % 3], bisected.vertex[(corner + 2) % 3], 0.5);
    if (!is_admissible(cut)) return outcome;
    carry_out(cut, outcome);
    while (!chain.empty() && !is_unchanged({chain.back()})) chain.pop_back();
  }
  outcome.is_done = true;
  return outcome;
}

}  // namespace tentpole
