#include "host/march/judge_patch.hpp"

#include <algorithm>

#include "host/batch/energy_balance.hpp"

namespace tentpole {
namespace {

/// Part of max_damage_step by which damage may grow in cells that are larger than those at cracks should be.
constexpr double coarse_damage_step = 0.05;

/// A patch that the kernel could not solve: smaller cells where there may be, then lower poles.
void retry_failed(const AdaptiveState& state, const PatchPlan& plan, PatchVerdict& verdict) {
  verdict.is_accepted = verdict.is_solved = false;
  if (!plan.is_tent()) return;
  if (state.has_refinement())
    for (const FootprintCell& cell : plan.below())
      if (longest_edge(state.front.mesh().simplex(cell.cell)) > state.limits.min_size) verdict.refine.push_back(cell);
  verdict.shorten = verdict.refine.empty() && state.memory[plan.vertex].halvings < max_halvings;
}

void judge_dissipation(const AdaptiveState& state, const PatchPlan& plan, const HostBatch& batch,
                       const PatchDescriptor& patch, PatchVerdict& verdict) {
  double largest = 0;
  for (int e = 0; e < patch.num_elements; ++e) {
    const double dissipation = batch.records[patch.first_element + e].dissipation;
    largest = std::max(largest, dissipation);
    if (!(dissipation > state.limits.tolerance)) continue;
    if (!plan.is_tent()) {
      verdict.is_accepted = false;
    } else if (longest_edge(state.front.mesh().simplex(plan.below()[e].cell)) > state.limits.min_size) {
      verdict.is_accepted = false;
      verdict.refine.push_back(plan.below()[e]);
    } else {
      ++verdict.min_size_hits;
    }
  }
  if (plan.is_tent()) verdict.dissipation_ratio = static_cast<float>(largest / state.limits.tolerance);
}

/// Damage that grows needs cells of crack_size and steps of max_damage_step. A surface at rest may have had larger
/// ones.
void judge_damage(const AdaptiveState& state, const PatchPlan& plan, const HostBatch& batch,
                  const PatchDescriptor& patch, PatchVerdict& verdict) {
  const double limit = state.books.simulation.settings.fracture.max_damage_step;
  double change = 0;
  for (int f = 0; f < patch.num_fractures; ++f)
    change = std::max(change, batch.fracture_records[patch.first_fracture + f].largest_damage_change);
  if (change > 1.0001 * limit && state.memory[plan.vertex].halvings < max_halvings) {
    verdict.is_accepted = false;
    verdict.shorten = true;
  }
  if (!state.has_refinement() || !(change > coarse_damage_step * limit)) return;
  for (const FootprintCell& cell : plan.below())
    if (is_too_large_for_crack(state, cell.cell)) verdict.refine.push_back(cell);
  if (!verdict.refine.empty()) verdict.is_accepted = false;
}

}  // namespace

PatchVerdict judge_patch(const AdaptiveState& state, const PatchPlan& plan, const HostBatch& batch, int patch_index,
                         double energy_scale) {
  const PatchDescriptor& patch = batch.patches[patch_index];
  PatchVerdict verdict;
  const Simulation& simulation = state.books.simulation;
  const bool is_solved = static_cast<Status>(batch.records[patch.first_element].status) == Status::ok;
  // A deletion or flip can be left undone; a tent whose energies are wrong would be wrong again.
  if (!is_solved || (!plan.is_tent() && !is_balanced(batch, patch_index, energy_scale, simulation))) {
    retry_failed(state, plan, verdict);
    return verdict;
  }
  require_balance(batch, patch_index, energy_scale, simulation);
  if (state.has_refinement()) judge_dissipation(state, plan, batch, patch, verdict);
  judge_damage(state, plan, batch, patch, verdict);
  return verdict;
}

}  // namespace tentpole
