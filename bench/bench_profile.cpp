// Shares of assembly, solution and post-solution in a whole patch, solved the thesis's way with each of its assemblies
// and LAPACK's dense LU (tables 3.1 to 3.5), and ours.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include <benchmark/benchmark.h>

#include "bench/assembly/outflow_state.hpp"
#include "bench/assembly/patch_system.hpp"
#include "bench/checked_answer.hpp"
#include "bench/machine_peaks.hpp"
#include "bench/repeat_timed.hpp"
#include "bench/run_benchmarks.hpp"
#include "bench/sample_patches.hpp"
#include "kernels/launch/patch_solver.hpp"
#include "kernels/patch/dense_patch_solve.hpp"

namespace tentpole {
namespace {

constexpr int space_dimension = 3;

/// Adds all updates of one element to the patch matrix.
using AssembleElement =
    std::function<void(const ElementUpdates& updates, int element, MatrixView patch_matrix, int num_threads)>;

struct Stages {
  double assembly = 0, solution = 0, post = 0;  ///< [s]
};

/// A patch and all that is computed of it before any clock runs.
class ProfilePatch {
 public:
  ProfilePatch(int the_degree, int the_num_elements)
      : degree(the_degree),
        num_elements(the_num_elements),
        batch(sample_patches(space_dimension, degree, num_elements, 1)),
        tables(space_dimension, degree),
        system(polynomial_patch_system(batch)),
        solution(system.size),
        outflow(num_elements) {
    for (int element = 0; element < num_elements; ++element) updates.emplace_back(tables, batch.view(), element, true);
    solve_ours();  // for the energies of its records
  }

  /// The thesis's way.
  Stages solve(const AssembleElement& assemble, int num_threads) {
    Stages stages;
    stages.assembly = seconds_of([&] {
      matrix.assign(system.matrix.size(), 0.0);
      for (int element = 0; element < num_elements; ++element)
        assemble(updates[element], element, {matrix.data(), system.size}, num_threads);
    });
    Status status = Status::ok;
    double residual = 0;
    stages.solution = seconds_of([&] { status = solve_dense_patch(matrix, system.rhs, solution, residual, scratch); });
    if (status != Status::ok) require_answer("bench_profile: dense LU", INFINITY, 1e-12);
    stages.post = seconds_of([&] {
      for (int element = 0; element < num_elements; ++element)
        outflow[element] = outflow_state(tables, batch.view(), element, solution.data() + element * num_unknowns());
    });
    return stages;
  }

  /// Ours: the shares of its stages in the wall time of one call.
  Stages solve_ours() {
    const ReferenceTables reference_tables(space_dimension, degree);
    PatchSolverTask task{};
    StageCycles cycles;
    task.batch = batch.view();
    task.tables = reference_tables.view();
    task.scratch_stride = patch_scratch_size(task.tables, batch.patches, 1);
    own_scratch.resize(task.scratch_stride);
    task.scratch = own_scratch.data();
    task.cycles = &cycles;
    task.shape = {1, 1};
    const double seconds = seconds_of([&] { solve_patches_host(task); });
    const double all = static_cast<double>(cycles.assembly + cycles.solution + cycles.post_solution);
    return {seconds * cycles.assembly / all, seconds * cycles.solution / all, seconds * cycles.post_solution / all};
  }

  /// Of the coefficients against the polynomial, and of the outflow energies against those of the patch solver.
  double error() const {
    double error = relative_difference(solution, batch.exact);
    for (int element = 0; element < num_elements; ++element) {
      const double expected = batch.records[element].outflow_energy;
      error = std::max(error, relative_difference({&outflow[element].energy, 1}, {&expected, 1}));
    }
    return error;
  }
  double own_error() const { return polynomial_error(batch, num_elements); }

  int num_unknowns() const { return tables.num_unknowns; }

  int degree, num_elements;
  TentBatch batch;
  CellTables tables;
  DensePatch system;
  std::vector<ElementUpdates> updates;
  std::vector<double> matrix, solution, own_scratch;
  std::vector<OutflowState> outflow;  ///< [element]
  DenseSolveScratch scratch;
};

struct Size {
  int degree, num_elements;

  std::string name() const { return "/d:4/k:" + std::to_string(degree) + "/K:" + std::to_string(num_elements); }
};

/// The patch of the running benchmark: benchmarks of one size follow each other.
ProfilePatch& patch_of(const Size& size) {
  static std::unique_ptr<ProfilePatch> current;
  if (!current || current->degree != size.degree || current->num_elements != size.num_elements) {
    current.reset();
    current = std::make_unique<ProfilePatch>(size.degree, size.num_elements);
  }
  return *current;
}

void report(benchmark::State& state, const ProfilePatch& patch, const Stages& sum, double error) {
  const double repetitions = static_cast<double>(state.iterations());
  const double all = sum.assembly + sum.solution + sum.post;
  state.counters["n"] = patch.num_unknowns();
  state.counters["N"] = patch.system.size;
  state.counters["assembly_%"] = 100 * sum.assembly / all;
  state.counters["solution_%"] = 100 * sum.solution / all;
  state.counters["post_%"] = 100 * sum.post / all;
  state.counters["assembly_s"] = sum.assembly / repetitions;
  state.counters["solution_s"] = sum.solution / repetitions;
  state.counters["post_s"] = sum.post / repetitions;
  state.counters["error"] = error;
}

/// Repeats `solve`, which returns stages, and sums them up.
template <class Solve>
Stages repeat_stages(benchmark::State& state, Solve solve) {
  Stages sum;
  repeat_timed(state, [&] {
    const Stages stages = solve();
    sum.assembly += stages.assembly;
    sum.solution += stages.solution;
    sum.post += stages.post;
    return stages.assembly + stages.solution + stages.post;
  });
  return sum;
}

void run_thesis(benchmark::State& state, const std::string& name, const AssembleElement& assemble, const Size& size,
                int num_threads) {
  ProfilePatch& patch = patch_of(size);
  const Stages sum = repeat_stages(state, [&] { return patch.solve(assemble, num_threads); });
  const std::string what = "bench_profile: " + name + size.name();
  report(state, patch, sum, require_answer(what, patch.error(), 1e-9));
}

void run_ours(benchmark::State& state, const Size& size) {
  ProfilePatch& patch = patch_of(size);
  const Stages sum = repeat_stages(state, [&] { return patch.solve_ours(); });
  const std::string what = "bench_profile: ours" + size.name();
  report(state, patch, sum, require_answer(what, patch.own_error(), 1e-9));
}

struct Assembly {
  std::string name;
  int num_threads;
  AssembleElement assemble;
};

AssembleElement with(const AddUpdate& add) {
  return [add](const ElementUpdates& updates, int element, MatrixView matrix, int) {
    assemble_updates(updates, element, 0, matrix, add);
  };
}

std::vector<Assembly> assemblies() {
  std::vector<Assembly> list{
      {"library_operators", 1, with(add_with_library_operators)},
      {"sequential", 1, with(add_sequential)},
      {"vectorized", 1, with(add_vectorized)},
      {"threaded_rows", num_cores(), [](const ElementUpdates& updates, int element, MatrixView matrix, int threads) {
         assemble_updates(updates, element, 0, matrix, [threads](const UpdateRows& update, MatrixView block) {
           add_threaded_rows(update, block, threads);
         });
       }}};
  if (const std::optional<Device> device = benchmark_device("bench_profile"))
    list.push_back({"offload_persistent", num_cores(),
                    [device](const ElementUpdates& updates, int element, MatrixView matrix, int threads) {
                      TrafficCounters traffic;
                      assemble_offload_persistent(updates, element, 0, matrix, *device, threads, traffic);
                    }});
  return list;
}

void add(const std::string& variant, const Size& size, int num_threads, std::function<void(benchmark::State&)> run) {
  const std::string name = "profile/" + variant + size.name() + "/threads:" + std::to_string(num_threads);
  benchmark::RegisterBenchmark(name.c_str(), std::move(run))->Unit(benchmark::kMillisecond)->UseManualTime();
}

void register_size(const Size& size, const std::vector<Assembly>& list) {
  for (const Assembly& assembly : list)
    add(assembly.name, size, assembly.num_threads, [=](benchmark::State& state) {
      run_thesis(state, assembly.name, assembly.assemble, size, assembly.num_threads);
    });
  add("ours", size, 1, [=](benchmark::State& state) { run_ours(state, size); });
}

/// Two elements at every degree (the fewest that couple), and all 24 tetrahedra around a vertex while N <= 2520.
void register_profiles() {
  const std::vector<Assembly> list = assemblies();
  for (int degree = 1; degree <= 3; ++degree) register_size({degree, 24}, list);
  for (int degree = 1; degree <= max_degree; ++degree) register_size({degree, 2}, list);
}

}  // namespace
}  // namespace tentpole

int main(int argc, char** argv) {
  tentpole::register_profiles();
  return tentpole::run_benchmarks(argc, argv);
}
