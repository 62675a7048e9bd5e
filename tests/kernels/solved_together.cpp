#include "tests/kernels/solved_together.hpp"

#include <algorithm>

#include "kernels/element/with_dimension.hpp"
#include "kernels/launch/patch_solver.hpp"
#include "kernels/patch/solve_patch.hpp"

namespace tentpole {

std::vector<double> team_scratch(const ReferenceTables& tables, const TentBatch& batch, int lanes) {
  return std::vector<double>(patch_scratch_size(tables.view(), batch.patches, std::max(lanes, 2)));
}

TentBatch solved_together(TentBatch batch, int lanes) {
  const ReferenceTables tables(batch.dimension, batch.degree);
  std::vector<double> scratch = team_scratch(tables, batch, lanes);
  const PatchBatch view = batch.view();
  with_dimension(batch.dimension, [&](auto dimension) {
#pragma omp parallel num_threads(lanes)
    {
      const TeamLanes team{omp_get_thread_num(), omp_get_num_threads()};
      StageCycles cycles;
      for (int patch = 0; patch < view.num_patches; ++patch) {
        solve_patch<dimension()>(view, tables.view(), patch, scratch.data(), cycles, team);
        team.synchronize();
      }
    }
  });
  return batch;
}

}  // namespace tentpole
