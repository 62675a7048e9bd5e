#pragma once

#include <vector>

#include "common/status.hpp"
#include "host/batch/host_batch.hpp"
#include "host/march/plan_patch.hpp"

namespace tentpole {

/// Pole heights are halved at most this often before a failed patch ends the run.
inline constexpr int max_halvings = 20;

/// What becomes of a solved patch.
struct PatchVerdict {
  bool is_accepted = true;
  bool is_solved = true;              ///< false: the kernel reports a status; it may not be accepted
  std::vector<FootprintCell> refine;  ///< cells to be split first
  bool shorten = false;               ///< the next pole at the vertex is to have half the height
  float dissipation_ratio = VertexMemory{}.dissipation_ratio;  ///< largest of a tent's elements / tolerance
  int min_size_hits = 0;
};

/// Judges patch number `patch` of a solved batch by the status of the kernel, the numerical dissipation of its elements
/// (with [adaptivity]) and the change of damage (max_damage_step). Throws std::runtime_error with place and time for a
/// tent whose energies are not balanced (host/batch/energy_balance.hpp); nothing may be committed then.
/// `energy_scale`: PatchEnergies::largest over all patches so far, those of this round too.
PatchVerdict judge_patch(const AdaptiveState& state, const PatchPlan& plan, const HostBatch& batch, int patch,
                         double energy_scale);

}  // namespace tentpole
