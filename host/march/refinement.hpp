#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/march/adaptive_state.hpp"

namespace tentpole {

/// Splits cells of the front and hands what lies below them, and the damage of cut crack edges, to the parts. The
/// device work waits until flush(), so a whole round of splits takes a launch per generation of parts. Between the
/// first split and flush() the element store must not give out slots for anything else.
class Refinement {
 public:
  explicit Refinement(AdaptiveState& state) : state_(state) {}

  /// Newest-vertex bisection with closure; false where the wanted split was refused. A cell that is gone counts as
  /// done.
  bool split(const FootprintCell& cell);

  /// Splits the cell that find() names until its longest edge is at most limits.crack_size, asking anew after each
  /// split. The cell, or none where find() names none; nothing where a split was refused.
  template <class Find>
  std::optional<std::int32_t> refine_for_crack(Find find) {
    const FrontMesh& mesh = state_.front.mesh();
    while (true) {
      const std::int32_t cell = find();
      if (cell == none || !is_too_large_for_crack(state_, cell)) return cell;
      const std::int64_t serial = mesh.cell(cell).serial;
      split({cell, serial});
      if (mesh.is_alive_cell(cell) && mesh.cell(cell).serial == serial) return std::nullopt;
    }
  }

  /// Cuts the edge (D = 1: the cell) between a and b; the new vertex, or none where it was refused.
  std::int32_t split_edge(std::int32_t a, std::int32_t b, double fraction);

  /// Transplants the solutions; call before anything else reads the store.
  void flush();

 private:
  void follow(const SplitOutcome& outcome);
  void follow_cell(const CellSplit& split, std::int32_t source, std::int32_t facet);
  void follow_crack(const EdgeSplit& split);
  bool is_current(const CellSplit& split, int side) const;

  AdaptiveState& state_;
  std::vector<std::vector<TransplantRequest>> generations_;  ///< those that read parts of an earlier one come later
  std::vector<std::int32_t> generation_of_slot_;             ///< [slot]: generation that writes it, or none
};

}  // namespace tentpole
