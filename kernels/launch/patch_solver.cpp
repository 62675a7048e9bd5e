#include "kernels/launch/patch_solver.hpp"

#include <algorithm>
#include <vector>

#include "kernels/element/with_dimension.hpp"
#include "kernels/patch/solve_patch.hpp"

namespace tentpole {
namespace {

/// One worker's share of a launch.
template <int D, class Lanes>
inline void run_patch(const PatchSolverTask& task, int patch, int worker, const Lanes& lanes) {
  StageCycles cycles;
  solve_patch<D>(task.batch, task.tables, patch, task.scratch + worker * task.scratch_stride, cycles, lanes);
  if (lanes.first() == 0) {
    task.cycles[worker].assembly += cycles.assembly;
    task.cycles[worker].solution += cycles.solution;
    task.cycles[worker].post_solution += cycles.post_solution;
  }
}

template <int D>
void run_on_host(const PatchSolverTask& task) {
  const int num_patches = task.batch.num_patches;
#pragma omp parallel for schedule(monotonic : dynamic, 1) num_threads(task.shape.workers)
  for (int patch = 0; patch < num_patches; ++patch) run_patch<D>(task, patch, omp_get_thread_num(), SerialLane{});
}

#ifdef TENTPOLE_OFFLOAD
template <int D>
void run_on_cpu_device(const PatchSolverTask task, int device_number) {
  const int num_patches = task.batch.num_patches, workers = task.shape.workers;
#pragma omp target teams num_teams(1) device(device_number) firstprivate(task)
#pragma omp parallel num_threads(workers)
  share_on_cpu_device(num_patches, 1,
                      [&](int patch) { run_patch<D>(task, patch, omp_get_thread_num(), SerialLane{}); });
}

// Teams that stay with their scratch and take every num_teams-th patch; SPMD as loop_on_gpu.
template <int D>
void run_on_gpu(const PatchSolverTask task, int device_number) {
  const int num_patches = task.batch.num_patches, teams = task.shape.workers, lanes = task.shape.lanes;
#pragma omp target teams num_teams(teams) thread_limit(lanes) device(device_number) firstprivate(task)
#pragma omp parallel num_threads(lanes)
  {
    const TeamLanes team{omp_get_thread_num(), omp_get_num_threads()};
    const int worker = omp_get_team_num(), workers = omp_get_num_teams();
    for (int patch = worker; patch < num_patches; patch += workers) {
      run_patch<D>(task, patch, worker, team);
      team.synchronize();
    }
  }
}
#endif

}  // namespace

long patch_scratch_size(const ReferenceTablesView& tables, const PatchDescriptor& patch, int lanes) {
  double start = 0;
  return with_dimension(tables.dimension, [&](auto dimension) {
    if (lanes == 1) return PatchWorkspace<dimension()>(tables, patch, &start, SerialLane{}).size();
    return PatchWorkspace<dimension()>(tables, patch, &start, TeamLanes{0, lanes}).size();
  });
}

long patch_scratch_size(const ReferenceTablesView& tables, std::span<const PatchDescriptor> patches, int lanes) {
  long largest = 0;
  for (const PatchDescriptor& patch : patches) largest = std::max(largest, patch_scratch_size(tables, patch, lanes));
  return largest;
}

void solve_patches_host(const PatchSolverTask& task) {
  with_dimension(task.tables.dimension, [&](auto dimension) { run_on_host<dimension()>(task); });
}

void solve_patches_device([[maybe_unused]] const PatchSolverTask& task, [[maybe_unused]] int device_number) {
#ifdef TENTPOLE_OFFLOAD
  with_dimension(task.tables.dimension, [&](auto dimension) {
    if (task.shape.lanes == 1)
      run_on_cpu_device<dimension()>(task, device_number);
    else
      run_on_gpu<dimension()>(task, device_number);
  });
#else
  refuse_launch("solve_patches_device");
#endif
}

void evaluate_patches_host(const PatchBatch& batch, const ReferenceTablesView& tables) {
  const std::span<const PatchDescriptor> patches(batch.patches, batch.num_patches);
  std::vector<double> scratch(patch_scratch_size(tables, patches, 1));
  with_dimension(tables.dimension, [&](auto dimension) {
    for (int patch = 0; patch < batch.num_patches; ++patch)
      check_patch<dimension()>(batch, tables, patch, scratch.data(), SerialLane{});
  });
}

double flops_per_element(const ReferenceTablesView& tables, int num_ports, int iterations) {
  const double n = tables.num_unknowns, r = tables.dimension * tables.num_facet_modes * num_ports;
  const double dimension = tables.dimension, pairs = (dimension + 1) * (dimension + 1);
  const double assembly =
      2 * n * n * (pairs * (1 + dimension) + tables.num_curvature_modes + dimension * (dimension + 1) / 2) +
      4 * n * r * (dimension + 1);
  const double elimination = 2.0 / 3.0 * n * n * n + 2 * n * n * r + 2 * n * r * r;
  const double recovery = 2 * n * n + 4 * n * r + 2 * r * r * iterations;
  return assembly + elimination + recovery;
}

}  // namespace tentpole
