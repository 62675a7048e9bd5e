#include <algorithm>
#include <chrono>

#include "bench/lu/variants.hpp"

namespace tentpole {

CondensedSolve::CondensedSolve(PatchSystems& systems, int num_patches, int num_threads)
    : systems_(&systems), tables_(systems.dimension, systems.degree) {
  task_.batch = systems.batch.view();
  task_.batch.num_patches = num_patches;
  task_.batch.num_elements = num_patches * systems.num_elements;
  task_.tables = tables_.view();
  task_.scratch_stride = patch_scratch_size(task_.tables, systems.batch.patches, 1);
  scratch_.resize(task_.scratch_stride * num_threads);
  cycles_.resize(num_threads);
  task_.scratch = scratch_.data();
  task_.cycles = cycles_.data();
  task_.shape = {num_threads, 1};
}

double CondensedSolve::solve() {
  std::fill(cycles_.begin(), cycles_.end(), StageCycles{});
  const auto start = std::chrono::steady_clock::now();
  solve_patches_host(task_);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  double solution = 0, all = 0;
  for (const StageCycles& worker : cycles_) {
    solution += static_cast<double>(worker.solution);
    all += static_cast<double>(worker.assembly + worker.solution + worker.post_solution);
  }
  return elapsed.count() * solution / all;
}

std::vector<double> CondensedSolve::solution() const {
  const TentBatch& batch = systems_->batch;
  const long n = batch.num_unknowns();
  std::vector<double> solution;
  for (int element = 0; element < systems_->num_elements; ++element) {
    const double* coefficients = batch.coefficients.data() + batch.elements[element].result_slot * n;
    solution.insert(solution.end(), coefficients, coefficients + n);
  }
  return solution;
}

double CondensedSolve::flops() const {
  const TentBatch& batch = systems_->batch;
  const double n = batch.num_unknowns();
  double flops = 0;
  for (long element = 0; element < task_.batch.num_elements; ++element) {
    int ports = 0;
    for (int facet = 0; facet <= batch.dimension + 1; ++facet)
      ports += is_shared(batch.elements[element].facet_kind[facet]);
    const double r = batch.dimension * tables_.view().num_facet_modes * ports;
    const int iterations = batch.records[element].num_iterations;
    flops += 2.0 / 3.0 * n * n * n + 2 * n * n * r + 2 * n * r * r + 2 * n * n + 4 * n * r + 2 * r * r * iterations;
  }
  return flops;
}

}  // namespace tentpole
