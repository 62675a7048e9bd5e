#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <vector>

#include "host/front/crack_edges.hpp"
#include "host/front/front_mesh.hpp"
#include "host/front/front_operations.hpp"
#include "host/front/local_minima.hpp"

namespace tentpole {

/// How steep a tent may make the front: gentle slopes leave room for splits.
enum class Pitch { gentle, full };

struct AdaptiveFrontRules {
  double causality = 0.95;      ///< gamma in (0, 1]
  double pitch_factor = 0.65;   ///< gentle poles obey the limits for this fraction of gamma / c
  double max_pole_speed = 0.5;  ///< of an inclined pole, as a fraction of the slowest wave speed around, < 1
  double start_time = 0;
};

/// The front of an adaptive run, D = 1 or 2: a mesh with times whose vertices rise (tents), and whose cells are split,
/// merged and flipped (docs/meshing.md). Invariants: causal, |grad tau| <= g = gamma / c on every cell; every cell
/// obeys the progress rule (progress_rule.hpp), so every local minimum can rise; conforming; boundaries, region
/// interfaces and cracks are kept. Operations are planned on a const front, solved, and committed; plans at different
/// local minima of one front never touch each other. All that happens is a function of the sequence of commits. Units:
/// those of the mesh and the wave speeds.
class AdaptiveFront {
 public:
  /// `region_wave_speed` [num regions]: fastest wave, > 0. Throws std::invalid_argument with the value otherwise.
  AdaptiveFront(const SpaceMesh& mesh, std::span<const double> region_wave_speed, const AdaptiveFrontRules& rules = {});

  const FrontMesh& mesh() const { return mesh_; }
  double time(int vertex) const { return mesh_.time(vertex); }

  /// gamma / c of a region.
  double slope_limit(int region) const { return slope_limit_[region]; }

  // --- tents
  /// The local minima in (time, scrambled id) earlier than `end_time`, ascending. No two of them share a cell.
  std::vector<std::int32_t> local_minima(double end_time) const;
  bool is_local_minimum(int vertex) const { return minima_.contains(vertex); }

  /// Earliest time on the front. O(number of local minima).
  double minimum_time() const;

  /// Top of the vertical tent pole at a local minimum: the causal and the progress limit for gamma; with a gentle pitch
  /// for pitch_factor gamma unless that leaves less than 0.2 of an altitude / c; at most `end_time`, and half of the
  /// rest where less than two heights remain. Throws std::runtime_error where the precision of the times is exhausted.
  double pole_top_time(int vertex, double end_time, Pitch pitch = Pitch::gentle) const;
  void raise(int vertex, double time);

  /// Where the vertex should go for better cells: half of the way to the mean of its neighbours (line vertices: those
  /// on the line) or, if that is better, to the mean of the tips of the equilateral triangles on the facets round it.
  /// Nothing where it may not move or its worst cell would gain less than 2 %.
  std::optional<Point> smoothing_target(int vertex) const;

  /// Pole from a local minimum towards `target`, no further than the pole speed allows; `line` vertices stay on their
  /// line, corners and crack vertices stay where they are (nothing). Height and shift shrink by 0.7 up to 7 times until
  /// every element has a volume and every new cell is admissible and keeps its orientation and 0.1 of its area; else
  /// nothing, and the vertical pole is taken.
  std::optional<InclinedTent> plan_inclined_tent(int vertex, const Point& target, double end_time) const;
  void raise_inclined(int vertex, const InclinedTent& tent);

  // --- coarsening, shape
  /// Removal of a vertex that is no corner and on no crack: the triangulation of the hole (of up to 8 vertices) with
  /// the best worst shape among those that obey `limits`, causality and progress and whose planes pass above the vertex
  /// by 1e-3 longest edge / c. An interface vertex keeps the interface: each side is triangulated on its own.
  /// Elements are (vertex, C), one per new cell C, in their order.
  std::optional<CellExchange> plan_deletion(int vertex, const DeletionLimits& limits = {}) const;

  /// Flip of an inner edge that is no interface and no crack, where it improves the smallest angle of its two cells and
  /// the new cells are admissible and pass above the old edge by 1e-3 longest edge / c.
  std::optional<FlipPlan> plan_flip(int a, int b) const;

  /// Ids of the new cells in their order. Throws std::logic_error where a cell below has changed since.
  std::vector<std::int32_t> commit(const CellExchange& exchange);
  bool is_unchanged(const Footprint& footprint) const;

  // --- refinement
  /// Newest-vertex bisection of a cell with its closure (D = 1: halves). Every single split is refused unless the
  /// children obey the progress rule; then is_done is false and splits of the closure may have been done.
  SplitOutcome try_split(int cell);

  /// Cuts the edge (D = 1: the cell) between a and b at a + fraction (b - a), 0 < fraction < 1, unless the children
  /// would break the progress rule.
  SplitOutcome split_edge(int a, int b, double fraction);

  // --- cracks
  /// Makes the edge (D = 1: a == b, the vertex) a fracture surface; its number. Throws std::invalid_argument where
  /// there is no such edge inside the domain.
  std::int32_t mark_crack(int a, int b);
  std::int32_t crack_edge(int a, int b) const { return cracks_.find(a, b); }  ///< number or none
  const CrackEdges& cracks() const { return cracks_; }

  // --- whole front
  /// Largest |grad tau| c / gamma over all cells.
  double steepness() const;

  /// Throws std::runtime_error naming the first broken invariant.
  void check() const;

  /// Checkpoint of all that changes; load wants a front made from the same mesh, speeds and rules and then goes on
  /// bitwise like the saved one. Throws std::runtime_error where the bytes are damaged.
  void save(std::ostream& stream) const;
  void load(std::istream& stream);

 private:
  struct EdgeCut;

  double slope_limit_of(int cell) const { return slope_limit_[mesh_.cell(cell).region]; }
  double latest_time(int vertex, double factor) const;
  double latest_gentle_time(int vertex) const;
  Footprint footprint_of(std::span<const std::int32_t> cells) const;
  std::vector<std::int32_t> replace(std::span<const std::int32_t> removed, std::span<const NewFrontCell> added,
                                    std::span<const NewBoundaryFacet> boundary = {});
  void find_all_minima();

  std::optional<Point> movable_target(int vertex, const Point& target) const;
  bool is_admissible(int vertex, const InclinedTent& tent) const;
  double star_quality(int vertex, const Point& position) const;

  double deletion_cost(int vertex, int region, const FrontVertices& corners, const DeletionLimits& limits) const;
  bool merged_line_is_admissible(int vertex, std::int32_t a, std::int32_t b) const;

  EdgeCut edge_cut(int a, int b, double fraction) const;
  bool is_admissible(const EdgeCut& cut) const;
  void carry_out(const EdgeCut& cut, SplitOutcome& outcome);
  std::int32_t across_refinement_edge(int cell) const;

  AdaptiveFrontRules rules_;
  std::vector<double> slope_limit_;  ///< [region]
  FrontMesh mesh_;
  LocalMinima minima_;
  CrackEdges cracks_;
};

}  // namespace tentpole
