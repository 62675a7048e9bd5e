#pragma once

#include <vector>

#include "host/march/judge_patch.hpp"
#include "host/march/patch_writer.hpp"

namespace tentpole {

/// A plan and where its solution is.
struct RoundPatch {
  PatchPlan plan;
  std::int32_t batch = 0;
  std::int32_t patch = 0;
  PatchVerdict verdict;
};

/// All local minima of one front: what is planned there, the solved batches, the verdicts.
struct AdaptiveRound {
  std::vector<RoundPatch> patches;  ///< in the order of the vertices
  std::vector<HostBatch> batches;

  const HostBatch& batch_of(const RoundPatch& patch) const { return batches[patch.batch]; }
  const PatchDescriptor& descriptor(const RoundPatch& patch) const { return batch_of(patch).patches[patch.patch]; }
};

/// Plans an operation at every local minimum earlier than the end time, and solves them in batches of at most
/// `max_patches`; while one is solved the next is written. Empty when the front has reached the end.
AdaptiveRound solve_round(AdaptiveState& state, PatchWriter& writer, int max_patches);

/// Gives back the result slots of a round that will not be committed.
void give_up_round(AdaptiveState& state, const AdaptiveRound& round);

}  // namespace tentpole
