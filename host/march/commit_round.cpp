#include "host/march/commit_round.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "host/march/grow_cracks.hpp"

namespace tentpole {
namespace {

/// Poles of a patch above tolerance are halved this often where no split is admissible, before it is accepted so.
constexpr int patient_halvings = 2;

class RoundCommit {
 public:
  RoundCommit(AdaptiveState& state, DefectSearch& search, const AdaptiveRound& round)
      : state_(state), search_(search), round_(round), refinement_(state) {
    for (const HostBatch& batch : round.batches) accepted_.emplace_back(batch.patches.size(), 0);
  }

  std::vector<std::vector<std::uint8_t>> run() {
    for (const RoundPatch& patch : round_.patches)
      if (patch.verdict.is_accepted) accept(patch);
    search_.search(new_cells_);
    retry_pending();
    for (const RoundPatch& patch : round_.patches)
      if (!patch.verdict.is_accepted) reject_or_accept(patch);
    if (state_.has_refinement() && state_.has_fracture())
      for (const RoundPatch& patch : round_.patches) refine_at_cracks(patch);
    grow_cracks(state_, refinement_);
    refinement_.flush();
    return std::move(accepted_);
  }

 private:
  const FrontMesh& mesh() const { return state_.front.mesh(); }

  void accept(const RoundPatch& patch) {
    accepted_[patch.batch][patch.patch] = 1;
    state_.counts.min_size_hits += patch.verdict.min_size_hits;
    VertexMemory& memory = state_.memory[patch.plan.vertex];
    memory = {};
    memory.dissipation_ratio = patch.verdict.dissipation_ratio;
    count(patch.plan.operation);
    if (patch.plan.is_tent())
      accept_tent(patch);
    else
      accept_exchange(patch);
  }

  void count(PatchOperation operation) {
    AdaptiveCounts& counts = state_.counts;
    if (operation == PatchOperation::inclined_tent) ++counts.inclined;
    if (operation == PatchOperation::deletion) ++counts.deletions;
    if (operation == PatchOperation::flip) ++counts.flips;
  }

  /// The element below a cell changes.
  void set_source(std::int32_t cell, std::int32_t slot, std::int32_t facet) {
    state_.sources.slot[cell] = slot;
    state_.sources.facet[cell] = facet;
  }
  void release_sources(const Footprint& footprint) {
    for (const FootprintCell& below : footprint)
      if (state_.sources.slot[below.cell] != none) state_.books.store.release(state_.sources.slot[below.cell]);
  }
  void note_new_cell(std::int32_t cell, const ElementRecord& record) {
    state_.measure(cell);
    new_cells_.push_back({cell, record.max_principal_stress});
  }

  void accept_tent(const RoundPatch& patch) {
    const PatchPlan& plan = patch.plan;
    const PatchDescriptor& descriptor = round_.descriptor(patch);
    const HostBatch& batch = round_.batch_of(patch);
    if (plan.operation == PatchOperation::inclined_tent)
      state_.front.raise_inclined(plan.vertex, plan.top);
    else
      state_.front.raise(plan.vertex, plan.top.time);
    release_sources(plan.below());
    for (int e = 0; e < descriptor.num_elements; ++e) {
      const ElementDescriptor& element = batch.elements[descriptor.first_element + e];
      const std::int32_t cell = plan.below()[e].cell;
      set_source(cell, element.result_slot, facet_table(element, mesh().dimension(), element.pole));
      note_new_cell(cell, batch.records[descriptor.first_element + e]);
    }
    for (int f = descriptor.first_fracture; f < descriptor.first_fracture + descriptor.num_fractures; ++f)
      update_crack(batch.crack_edges[f], batch.fracture_records[f]);
  }

  void update_crack(std::int32_t edge, const FractureRecord& record) {
    CrackEdgeState& crack = state_.crack_state[edge];
    for (int point = 0; point < crack.num_points; ++point) {
      crack.damage[point] = record.damage[point];
      crack.gap[point] = record.gap[point];
    }
    crack.effective_traction = record.largest_effective_traction;
    const auto most = std::max_element(record.mode_points, record.mode_points + 3) - record.mode_points;
    state_.crack_mode[edge] = static_cast<CrackMode>(most);
  }

  /// Each new cell lies on the outflow facet of the element that has all its vertices.
  void accept_exchange(const RoundPatch& patch) {
    const CellExchange& exchange = patch.plan.exchange;
    const int first = round_.descriptor(patch).first_element;
    const HostBatch& batch = round_.batch_of(patch);
    release_sources(exchange.below);
    const std::vector<std::int32_t> cells = state_.front.commit(exchange);
    state_.follow_front();
    std::vector<int> num_cells(exchange.between.size());
    for (const std::int32_t cell : cells) {
      const auto [element, facet] = element_below(exchange, mesh().vertices(cell));
      const std::int32_t slot = batch.elements[first + element].result_slot;
      if (num_cells[element]++ > 0) state_.books.store.share(slot);
      set_source(cell, slot, facet);
      note_new_cell(cell, batch.records[first + element]);
    }
  }

  struct ElementFacet {
    std::size_t element;
    std::int32_t facet;  ///< number of the corner that is not on it
  };
  static ElementFacet element_below(const CellExchange& exchange, std::span<const std::int32_t> cell) {
    for (std::size_t element = 0; element < exchange.between.size(); ++element) {
      const auto& vertices = exchange.between[element].vertex;
      if (!std::ranges::includes(std::span(vertices).first(cell.size() + 1), cell)) continue;
      const auto apart = std::ranges::mismatch(vertices, cell).in1;
      return {element, static_cast<std::int32_t>(apart - vertices.begin())};
    }
    throw std::logic_error("a new cell of the front lies on no element of its patch");
  }

  void want_split(const FootprintCell& cell) {
    if (!refinement_.split(cell)) state_.pending.push_back({cell.cell, cell.serial});
  }

  void retry_pending() {
    const std::vector<PendingSplit> pending = std::move(state_.pending);
    state_.pending.clear();
    for (const PendingSplit& cell : pending) want_split({cell.cell, cell.serial});
  }

  void reject_or_accept(const RoundPatch& patch) {
    const PatchVerdict& verdict = patch.verdict;
    for (const FootprintCell& cell : verdict.refine) want_split(cell);
    const bool changed = !state_.front.is_unchanged(patch.plan.below());
    const bool is_tent = patch.plan.operation == PatchOperation::tent;
    bool shorten = verdict.shorten;
    if (!changed && !shorten && is_tent) {
      shorten = state_.memory[patch.plan.vertex].halvings < (verdict.is_solved ? patient_halvings : max_halvings);
      if (!shorten && verdict.is_solved) return accept_above_tolerance(patch);
      if (!shorten) fail(patch);
    }
    ++state_.counts.rejected;
    VertexMemory& memory = state_.memory[patch.plan.vertex];
    memory.dissipation_ratio = VertexMemory{}.dissipation_ratio;
    memory.keeps_shape = !is_tent || (memory.keeps_shape && !changed);
    if (shorten) ++memory.halvings;
    const PatchDescriptor& descriptor = round_.descriptor(patch);
    for (int e = 0; e < descriptor.num_elements; ++e)
      state_.books.store.release(round_.batch_of(patch).elements[descriptor.first_element + e].result_slot);
  }

  /// No split was admissible: the front has to move on first.
  void accept_above_tolerance(const RoundPatch& patch) {
    const std::size_t first = new_cells_.size();
    ++state_.counts.refused;
    accept(patch);
    search_.search(std::span(new_cells_).subspan(first));
  }

  [[noreturn]] void fail(const RoundPatch& patch) const {
    const Scaling& scaling = state_.books.simulation.scaling;
    const PatchDescriptor& descriptor = round_.descriptor(patch);
    const ElementRecord& record = round_.batch_of(patch).records[descriptor.first_element];
    const Point& position = mesh().position(patch.plan.vertex);
    char text[400];
    std::snprintf(text, sizeof text,
                  "tent at (%.6g, %.6g) m, t = %.6g s: %s, and its cells have the least size (%.3g m). "
                  "Lower \"adaptivity.min_size\" or \"front.causality\", or raise \"fracture.relaxation_time\".",
                  position[0] * scaling.length, position[1] * scaling.length,
                  mesh().time(patch.plan.vertex) * scaling.time(), status_name(static_cast<Status>(record.status)),
                  state_.limits.min_size * scaling.length);
    throw std::runtime_error(text);
  }

  /// Cells at a crack whose damage grows are kept small.
  void refine_at_cracks(const RoundPatch& patch) {
    if (!mesh().is_alive_vertex(patch.plan.vertex)) return;
    std::vector<FootprintCell> large;
    for (const CellCorner& entry : mesh().star(patch.plan.vertex)) {
      if (!is_too_large_for_crack(state_, entry.cell)) continue;
      const auto vertices = mesh().vertices(entry.cell);
      if (std::ranges::any_of(vertices, [&](std::int32_t v) { return touches_active_crack(state_, v); }))
        large.push_back({entry.cell, mesh().cell(entry.cell).serial});
    }
    for (const FootprintCell& cell : large) want_split(cell);
  }

  AdaptiveState& state_;
  DefectSearch& search_;
  const AdaptiveRound& round_;
  Refinement refinement_;
  std::vector<TestedCell> new_cells_;
  std::vector<std::vector<std::uint8_t>> accepted_;
};

}  // namespace

std::vector<std::vector<std::uint8_t>> commit_round(AdaptiveState& state, DefectSearch& search,
                                                    const AdaptiveRound& round) {
  return RoundCommit(state, search, round).run();
}

}  // namespace tentpole
