// LU of real patch matrices: LAPACK, Eigen and ours, factor and solve with one right-hand side.
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "bench/blas_threads.hpp"
#include "bench/checked_answer.hpp"
#include "bench/lu/variants.hpp"
#include "bench/machine_peaks.hpp"
#include "bench/repeat_timed.hpp"
#include "bench/run_benchmarks.hpp"
#include "bench/sample_patches.hpp"
#include "bench/thread_speedups.hpp"

namespace tentpole {
namespace {

struct Size {
  int dimension, degree, num_elements;

  std::string name() const {
    return "/d:" + std::to_string(dimension + 1) + "/k:" + std::to_string(degree) +
           "/K:" + std::to_string(num_elements);
  }
};

constexpr int patches_per_batch = 16;

/// The systems of the running benchmark: benchmarks of one size follow each other.
PatchSystems& systems_of(const Size& size) {
  static std::unique_ptr<PatchSystems> current;
  if (!current || current->dimension != size.dimension || current->degree != size.degree ||
      current->num_elements != size.num_elements) {
    current.reset();
    current = std::make_unique<PatchSystems>(size.dimension, size.degree, size.num_elements, patches_per_batch);
  }
  return *current;
}

ThreadSpeedups& speedups() {
  static ThreadSpeedups kept;
  return kept;
}

/// Ends the program unless the solution satisfies its equations to 1e-12 and is the reference's.
void check_solution(benchmark::State& state, const std::string& what, const PatchSystems& systems,
                    const std::vector<double>& solution) {
  const SolutionError error = solution_error(systems, solution);
  state.counters["difference"] =
      require_answer("bench_lu: " + what + ", difference from the reference", error.difference, 1e-10);
  state.counters["error"] = require_answer("bench_lu: " + what + ", residual", error.residual, 1e-12);
}

double dense_flops(const PatchSystems& systems) {
  const double size = systems.system.size;
  return 2.0 / 3.0 * size * size * size + 2 * size * size;
}

/// What every variant reports. Useful operations are those of a dense factorisation and solve, whatever was done.
void report(benchmark::State& state, const PatchSystems& systems, double seconds, int num_patches, double executed,
            int num_threads) {
  const double rate = num_patches / seconds;
  state.counters["n"] = systems.batch.num_unknowns();
  state.counters["N"] = systems.system.size;
  state.counters["s_per_patch"] = 1 / rate;
  state.counters["GF/s"] = dense_flops(systems) * rate * 1e-9;
  state.counters["executed_GF/s"] = executed / seconds * 1e-9;
  state.counters["dgemm_%"] = 100 * executed / seconds / machine_peaks(num_threads).dgemm;
}

void report_gain(benchmark::State& state, const ThreadGain& gain) {
  state.counters["speedup"] = gain.speedup;
  state.counters["efficiency"] = gain.efficiency;
}

/// The three dense variants.
template <class Variant>
double time_dense(benchmark::State& state, const char* name, const Size& size, int num_threads) {
  const PatchSystems& systems = systems_of(size);
  Variant variant;
  std::vector<double> solution;
  set_blas_threads(num_threads);
  const double seconds = repeat_timed(state, [&] { return seconds_of([&] { variant.solve(systems, solution); }); });
  set_blas_threads(1);
  check_solution(state, name + size.name(), systems, solution);
  report(state, systems, seconds, 1, dense_flops(systems), num_threads);
  return seconds;
}

void run_lapack(benchmark::State& state, const Size& size, int num_threads) {
  const double seconds = time_dense<LapackSolve>(state, "lapack", size, num_threads);
  report_gain(state, speedups().gain("lapack" + size.name(), num_threads, seconds, [&] {
    LapackSolve variant;
    std::vector<double> solution;
    variant.solve(systems_of(size), solution);
    return seconds_of([&] { variant.solve(systems_of(size), solution); });
  }));
}

/// All patches of the batch; the first alone where num_patches is 1.
void run_condensed(benchmark::State& state, const char* name, const Size& size, int num_patches, int num_threads) {
  PatchSystems& systems = systems_of(size);
  CondensedSolve variant(systems, num_patches, num_threads);
  const double seconds = repeat_timed(state, [&] { return variant.solve(); });
  require_answer(std::string("bench_lu: ") + name + size.name() + ", known polynomials",
                 polynomial_error(systems.batch, num_patches * size.num_elements), 1e-9);
  check_solution(state, name + size.name(), systems, variant.solution());
  report(state, systems, seconds, num_patches, variant.flops(), num_threads);
  if (num_patches > 1)
    report_gain(state, speedups().gain(name + size.name(), num_threads, seconds, [&] {
      CondensedSolve serial(systems, num_patches, 1);
      serial.solve();
      return serial.solve();
    }));
}

template <class Run>
void add(const char* variant, const Size& size, int num_threads, Run run) {
  const std::string name = std::string("lu/") + variant + size.name() + "/threads:" + std::to_string(num_threads);
  benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond)->UseManualTime();
}

void register_size(const Size& size) {
  const int most_threads = 2 * num_cores();
  for (int threads = 1; threads <= most_threads; ++threads)
    add("lapack", size, threads, [=](benchmark::State& state) { run_lapack(state, size, threads); });
  add("eigen", size, 1, [=](benchmark::State& state) { time_dense<EigenSolve>(state, "eigen", size, 1); });
  add("dense", size, 1, [=](benchmark::State& state) { time_dense<DenseSolve>(state, "dense", size, 1); });
  add("block_structured", size, 1,
      [=](benchmark::State& state) { run_condensed(state, "block_structured", size, 1, 1); });
  for (int threads = 1; threads <= most_threads; ++threads)
    add("batched", size, threads,
        [=](benchmark::State& state) { run_condensed(state, "batched", size, patches_per_batch, threads); });
}

/// The degrees at one element (the thesis's n), then patches of more elements.
void register_sizes() {
  for (const int dimension : {2, 3})
    for (int degree = 1; degree <= max_degree; ++degree) register_size({dimension, degree, 1});
  for (int degree = 1; degree <= max_degree; ++degree) register_size({2, degree, 4});
  for (const int num_elements : {4, 8, 16, 24}) register_size({3, 2, num_elements});
  for (const int num_elements : {4, 8, 16}) register_size({3, 3, num_elements});
}

}  // namespace
}  // namespace tentpole

int main(int argc, char** argv) {
  tentpole::register_sizes();
  return tentpole::run_benchmarks(argc, argv);
}
