#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <benchmark/benchmark.h>

#include "kernels/patch_solver.hpp"
#include "tests/kernels/tent_samples.hpp"

namespace tentpole {
namespace {

/// Real tents with a polynomial solution of the benchmark's degree: the answer is checked before any rate is printed.
class PatchBenchmark {
 public:
  PatchBenchmark(int dimension, int degree, int num_patches, int workers)
      : tables_(dimension, degree), batch_(sample(dimension, degree, num_patches)) {
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

  /// Largest coefficient error relative to the largest coefficient of the element.
  double error() const {
    double error = 0;
    const std::size_t n = batch_.num_unknowns();
    for (std::size_t e = 0; e < batch_.elements.size(); ++e) {
      double difference = 0, scale = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const double exact = batch_.exact[e * n + i];
        difference =
            std::max(difference, std::fabs(batch_.coefficients[batch_.elements[e].result_slot * n + i] - exact));
        scale = std::max(scale, std::fabs(exact));
      }
      error = std::max(error, difference / scale);
    }
    return error;
  }

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
  static TentBatch sample(int dimension, int degree, int num_patches) {
    TentOptions options;
    options.num_patches = num_patches;
    options.boundary_fraction = 0.1;
    options.data.source_fraction = 1;
    return random_tents(dimension, degree, options, 1);
  }

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
  const double error = patch_benchmark.error();
  if (!(error <= 1e-9)) {
    std::fprintf(stderr,
                 "bench_patch: D = %d, k = %d: the solution differs from the known polynomial by %.1e (limit 1e-9)\n",
                 dimension, degree, error);
    std::exit(1);
  }
  for (auto _ : state) patch_benchmark.solve();
  patch_benchmark.report(state);
}

void register_sizes(benchmark::internal::Benchmark* sizes) {
  for (const int workers : {1, 2}) {
    for (const int degree : {1, 2, 3, 4, 5, 6, 7}) sizes->Args({1, degree, 512, workers});
    for (const int degree : {1, 2, 3, 4, 5, 6}) sizes->Args({2, degree, degree < 4 ? 256 : 64, workers});
    for (const int degree : {1, 2, 3, 4}) sizes->Args({3, degree, degree < 3 ? 32 : 8, workers});
  }
}
BENCHMARK(solve_patches)
    ->ArgNames({"D", "k", "patches", "threads"})
    ->Apply(register_sizes)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace tentpole

BENCHMARK_MAIN();
