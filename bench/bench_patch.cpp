#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/checked_answer.hpp"
#include "bench/run_benchmarks.hpp"
#include "bench/sample_patches.hpp"
#include "kernels/patch_solver.hpp"
#include "tests/kernels/tent_samples.hpp"

namespace tentpole {
namespace {

/// Real tents of one size, of which batches are made; benchmarks of one size follow each other.
const TentBatch& distinct_tents(int dimension, int degree) {
  static TentBatch current;
  if (current.dimension != dimension || current.degree != degree) {
    TentOptions options;
    options.num_patches = dimension == 3 ? 8 : 64;
    options.boundary_fraction = 0.1;
    options.data.source_fraction = 1;
    current = random_tents(dimension, degree, options, 1);
  }
  return current;
}

/// Real tents with a polynomial solution of the benchmark's degree: the answer is checked before any rate is printed.
class PatchBenchmark {
 public:
  PatchBenchmark(int dimension, int degree, int num_patches, int workers)
      : tables_(dimension, degree), batch_(repeat_patches(distinct_tents(dimension, degree), num_patches)) {
    task_.batch = batch_.view();
    task_.tables = tables_.view();
    task_.scratch_stride = patch_scratch_size(task_.tables, batch_.patches, 1);
    scratch_.resize(task_.scratch_stride * workers);
    cycles_.resize(workers);
    task_.scratch = scratch_.data();
    task_.cycles = cycles_.data();
    task_.shape = {workers, 1};
  }

  void solve() { solve_patches_host(task_); }

  double error() const { return polynomial_error(batch_, static_cast<int>(batch_.elements.size())); }

  double flops() const {
    double flops = 0;
    for (std::size_t e = 0; e < batch_.elements.size(); ++e) {
      int ports = 0;
      for (int facet = 0; facet <= batch_.dimension + 1; ++facet)
        ports += is_shared(batch_.elements[e].facet_kind[facet]);
      flops += flops_per_element(task_.tables, ports, batch_.records[e].num_iterations);
    }
    return flops;
  }

  void report(benchmark::State& state) const {
    StageCycles sum;
    for (const StageCycles& worker : cycles_) {
      sum.assembly += worker.assembly;
      sum.solution += worker.solution;
      sum.post_solution += worker.post_solution;
    }
    const double all = static_cast<double>(sum.assembly + sum.solution + sum.post_solution) / 100;
    double iterations = 0;
    for (const PatchDescriptor& patch : batch_.patches)
      iterations += batch_.records[patch.first_element].num_iterations;
    state.counters["patches/s"] =
        benchmark::Counter(double(batch_.patches.size()), benchmark::Counter::kIsIterationInvariantRate);
    state.counters["elements/s"] =
        benchmark::Counter(double(batch_.elements.size()), benchmark::Counter::kIsIterationInvariantRate);
    state.counters["GF/s"] = benchmark::Counter(flops() * 1e-9, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["assembly_%"] = sum.assembly / all;
    state.counters["solution_%"] = sum.solution / all;
    state.counters["post_%"] = sum.post_solution / all;
    state.counters["coupling_products"] = iterations / batch_.patches.size();
  }

 private:
  ReferenceTables tables_;
  TentBatch batch_;
  PatchSolverTask task_{};
  std::vector<double> scratch_;
  std::vector<StageCycles> cycles_;
};

void solve_patches(benchmark::State& state) {
  const int dimension = int(state.range(0)), degree = int(state.range(1)), patches = int(state.range(2)),
            workers = int(state.range(3));
  PatchBenchmark patch_benchmark(dimension, degree, patches, workers);
  patch_benchmark.solve();
  const std::string what = "bench_patch: D = " + std::to_string(dimension) + ", k = " + std::to_string(degree);
  require_answer(what, patch_benchmark.error(), 1e-9);
  for (auto _ : state) patch_benchmark.solve();
  patch_benchmark.report(state);
}

/// Batches of 1 to 4096 patches, as long as one takes less than about a second on one thread.
void register_sizes(benchmark::internal::Benchmark* sizes) {
  for (const int dimension : {1, 2, 3})
    for (int degree = 1; degree <= (dimension == 3 ? 5 : max_degree); ++degree)
      for (const int patches : {1, 4, 16, 64, 256, 1024, 4096}) {
        const double unknowns = dimension * num_polynomials(dimension + 1, degree), elements = dimension == 3 ? 20 : 5;
        if (patches * elements * (3e-8 * unknowns * unknowns + 3e-10 * unknowns * unknowns * unknowns) > 2) continue;
        for (const int workers : {1, 2}) sizes->Args({dimension, degree, patches, workers});
      }
}
BENCHMARK(solve_patches)
    ->ArgNames({"D", "k", "patches", "threads"})
    ->Apply(register_sizes)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace tentpole

int main(int argc, char** argv) {
  return tentpole::run_benchmarks(argc, argv);
}
