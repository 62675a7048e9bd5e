// Whole patches in batches, on the host and on a device.
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/checked_answer.hpp"
#include "bench/patch_run.hpp"
#include "bench/run_benchmarks.hpp"
#include "bench/sample_patches.hpp"

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

void report(benchmark::State& state, PatchRun& run) {
  const StageCycles sum = run.cycles();
  const double all = static_cast<double>(sum.assembly + sum.solution + sum.post_solution) / 100;
  const TentBatch& batch = run.batch();
  double iterations = 0;
  for (const PatchDescriptor& patch : batch.patches) iterations += batch.records[patch.first_element].num_iterations;
  const auto rate = [](double amount) {
    return benchmark::Counter(amount, benchmark::Counter::kIsIterationInvariantRate);
  };
  state.counters["patches/s"] = rate(double(batch.patches.size()));
  state.counters["elements/s"] = rate(double(batch.elements.size()));
  state.counters["GF/s"] = rate(run.flops() * 1e-9);
  state.counters["assembly_%"] = sum.assembly / all;
  state.counters["solution_%"] = sum.solution / all;
  state.counters["post_%"] = sum.post_solution / all;
  state.counters["coupling_products"] = iterations / batch.patches.size();
  state.counters["workers"] = run.num_workers();
}

/// Real tents with a polynomial solution of the benchmark's degree: the answer is checked before any rate is printed.
void solve_patches(benchmark::State& state, const Device& device, LaunchShape shape) {
  const int dimension = int(state.range(0)), degree = int(state.range(1)), patches = int(state.range(2));
  PatchRun run(repeat_patches(distinct_tents(dimension, degree), patches), device, shape);
  run.solve();
  const std::string what =
      "bench_patch: D = " + std::to_string(dimension) + ", k = " + std::to_string(degree) + " on " + device.name;
  require_answer(what, run.error(), 1e-9);
  for (auto _ : state) run.solve();
  report(state, run);
}
void on_host(benchmark::State& state) {
  solve_patches(state, host_device(), {int(state.range(3)), 1});
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
BENCHMARK(on_host)
    ->Name("solve_patches")
    ->ArgNames({"D", "k", "patches", "threads"})
    ->Apply(register_sizes)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// What a device is tried with: on a CPU device threads, on a GPU teams of one, two and four warps, few of them and up
/// to all that are resident.
std::vector<LaunchShape> device_shapes(const Device& device) {
  const LaunchShape usual = device_shape(device, 0);
  if (usual.lanes == 1) return {{1, 1}, {2, 1}};
  std::vector<LaunchShape> shapes;
  for (const int warps : {1, 2, 4})
    for (const int share : {8, 4, 2, 1}) shapes.push_back({usual.workers / warps / share, warps * usual.lanes});
  return shapes;
}

void register_device_sizes(const Device& device) {
  for (const auto& [dimension, degree] : {std::pair(1, 3), {2, 2}, {2, 3}, {2, 4}, {3, 2}, {3, 3}, {3, 4}})
    for (const int patches : {64, 256, 1024, 4096, 16384}) {
      if (patches > (dimension == 3 ? 4096 : 16384)) continue;
      for (const LaunchShape shape : device_shapes(device))
        benchmark::RegisterBenchmark("device_patches",
                                     [=](benchmark::State& state) { solve_patches(state, device, shape); })
            ->ArgNames({"D", "k", "patches", "teams", "lanes"})
            ->Args({dimension, degree, patches, shape.workers, shape.lanes})
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    }
}

}  // namespace
}  // namespace tentpole

int main(int argc, char** argv) {
  if (const std::optional<tentpole::Device> device = tentpole::benchmark_device("bench_patch"))
    tentpole::register_device_sizes(*device);
  return tentpole::run_benchmarks(argc, argv);
}
