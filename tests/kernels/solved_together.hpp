#pragma once

#include <algorithm>

#include "kernels/launch/patch_solver.hpp"
#include "kernels/patch/solve_patch.hpp"
#include "tests/kernels/tent_samples.hpp"

namespace tentpole {

/// Scratch for lanes that share a patch, however few they are.
inline std::vector<double> team_scratch(const ReferenceTables& tables, const TentBatch& batch, int lanes) {
  return std::vector<double>(patch_scratch_size(tables.view(), batch.patches, std::max(lanes, 2)));
}

/// Solves the batch in host memory by a team of `lanes` threads, as a GPU does with teams of its own: the path that a
/// CPU device never takes, with as many lanes as we like, and open to the thread sanitizer.
template <int D>
TentBatch solved_together(TentBatch batch, int lanes) {
  const ReferenceTables tables(batch.dimension, batch.degree);
  std::vector<double> scratch = team_scratch(tables, batch, lanes);
  const PatchBatch view = batch.view();
#pragma omp parallel num_threads(lanes)
  {
    const TeamLanes team{omp_get_thread_num(), omp_get_num_threads()};
    StageCycles cycles;
    for (int patch = 0; patch < view.num_patches; ++patch) {
      solve_patch<D>(view, tables.view(), patch, scratch.data(), cycles, team);
      team.synchronize();
    }
  }
  return batch;
}

}  // namespace tentpole
