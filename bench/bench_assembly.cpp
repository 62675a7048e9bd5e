// The ladder of assembly (bench/README.md): one integration cell, an element with its facets, in all the ways from the
// thesis's first to ours.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include <benchmark/benchmark.h>

#include "bench/assembly/assembly_cost.hpp"
#include "bench/assembly/own_rungs.hpp"
#include "bench/assembly/reference_cell.hpp"
#include "bench/assembly/rungs.hpp"
#include "bench/checked_answer.hpp"
#include "bench/machine_peaks.hpp"
#include "bench/run_benchmarks.hpp"
#include "bench/sample_patches.hpp"

namespace tentpole {
namespace {

/// Integration cells of one size and their right answers.
struct AssemblyCase {
  AssemblyCase(int the_dimension, int the_degree, int the_num_cells)
      : dimension(the_dimension),
        degree(the_degree),
        num_cells(the_num_cells),
        batch(sample_patches(dimension, degree, 1, num_cells)),
        point_tables(dimension, degree),
        tables(dimension, degree),
        updates(point_tables, batch.view(), 0, false) {
    const std::size_t size = static_cast<std::size_t>(batch.num_unknowns()) * batch.num_unknowns();
    matrices.resize(size * num_cells);
    std::vector<double> scratch(updates.scratch_size());
    for (int update = 0; update < updates.size(); ++update) {
      const UpdateRows rows = updates.form(update, scratch.data());
      loop_flops += update_flops(rows);
      loop_bytes += update_bytes(rows);
    }
  }

  int num_unknowns() const { return batch.num_unknowns(); }
  MatrixView matrix() { return {matrices.data(), num_unknowns()}; }
  void clear() { std::fill_n(matrices.begin(), static_cast<long>(num_unknowns()) * num_unknowns(), 0.0); }
  void assemble(const AddUpdate& add) {
    clear();
    assemble_updates(updates, 0, 0, matrix(), add);
  }
  /// Of the first `count` cells.
  double error(int count) {
    const std::size_t size = static_cast<std::size_t>(num_unknowns()) * num_unknowns();
    double largest = 0;
    for (int cell = 0; cell < count; ++cell) {
      if (std::ssize(expected) <= cell)
        expected.push_back(reference_cell_matrix(batch.view(), dimension, degree, cell));
      largest = std::max(largest, relative_difference({&matrices[cell * size], size}, expected[cell]));
    }
    return largest;
  }

  int dimension, degree, num_cells;
  TentBatch batch;
  CellTables point_tables;
  ReferenceTables tables;
  ElementUpdates updates;
  std::vector<double> matrices;               ///< [cell][n][n]
  std::vector<std::vector<double>> expected;  ///< [cell][n][n], computed when first asked for
  double loop_flops = 0, loop_bytes = 0;      ///< of the double loops of one cell
};

/// The case of the running benchmark: benchmarks of one size follow each other.
AssemblyCase& assembly_case(int dimension, int degree) {
  static std::unique_ptr<AssemblyCase> current;
  if (!current || current->dimension != dimension || current->degree != degree) {
    current.reset();
    current = std::make_unique<AssemblyCase>(dimension, degree, num_cores());
  }
  return *current;
}

enum class Work { double_loops, products, tensors };

struct Rung {
  const char* name;
  Work work;
  bool whole_batch;
  std::vector<int> num_threads;
  std::function<void(AssemblyCase&, int num_threads)> assemble;
};

void report(benchmark::State& state, const Rung& rung, const AssemblyCase& cells, int num_threads, double error) {
  using benchmark::Counter;
  const ReferenceTablesView tables = cells.tables.view();
  const MachinePeaks peaks = machine_peaks(num_threads);
  const int count = rung.whole_batch ? cells.num_cells : 1;
  const double useful = count * useful_assembly_flops(tables);
  const double executed = rung.work == Work::double_loops ? cells.loop_flops
                          : rung.work == Work::products   ? matrix_product_flops(tables)
                                                          : useful;
  state.counters["n"] = cells.num_unknowns();
  state.counters["s_per_cell"] = Counter(count, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["GF/s"] = Counter(useful * 1e-9, Counter::kIsIterationInvariantRate);
  state.counters["executed_GF/s"] = Counter(executed * 1e-9, Counter::kIsIterationInvariantRate);
  state.counters["dgemm_%"] = Counter(100 * useful / peaks.dgemm, Counter::kIsIterationInvariantRate);
  if (rung.work == Work::double_loops) {
    state.counters["GB/s"] = Counter(cells.loop_bytes * 1e-9, Counter::kIsIterationInvariantRate);
    state.counters["copy_%"] = Counter(100 * cells.loop_bytes / peaks.copy, Counter::kIsIterationInvariantRate);
  }
  state.counters["error"] = error;
}

void run(benchmark::State& state, const Rung& rung, int dimension, int degree, int num_threads) {
  AssemblyCase& cells = assembly_case(dimension, degree);
  std::fill(cells.matrices.begin(), cells.matrices.end(), 0.0);
  for (auto _ : state) rung.assemble(cells, num_threads);
  const std::string what = std::string("bench_assembly: ") + rung.name + ", d = " + std::to_string(dimension + 1) +
                           ", k = " + std::to_string(degree);
  const double error = require_answer(what, cells.error(rung.whole_batch ? cells.num_cells : 1), 1e-12);
  report(state, rung, cells, num_threads, error);
}

std::vector<Rung> rungs_of_the_thesis() {
  std::vector<int> thread_counts{1};
  for (int threads = 2; threads <= 2 * num_cores(); threads *= 2) thread_counts.push_back(threads);
  return {
      {"library_operators",
       Work::double_loops,
       false,
       {1},
       [](AssemblyCase& cells, int) { cells.assemble(add_with_library_operators); }},
      {"sequential", Work::double_loops, false, {1}, [](AssemblyCase& cells, int) { cells.assemble(add_sequential); }},
      {"vectorized", Work::double_loops, false, {1}, [](AssemblyCase& cells, int) { cells.assemble(add_vectorized); }},
      {"threaded_rows", Work::double_loops, false, thread_counts,
       [](AssemblyCase& cells, int threads) {
         cells.assemble(
             [threads](const UpdateRows& update, MatrixView block) { add_threaded_rows(update, block, threads); });
       }},
      {"threaded_quadrature", Work::double_loops, false, thread_counts, [](AssemblyCase& cells, int threads) {
         cells.clear();
         assemble_threaded_quadrature(cells.updates, 0, 0, cells.matrix(), threads);
       }}};
}

std::vector<Rung> offload_rungs(const Device& device) {
  static TrafficCounters traffic;
  return {{"offload_transfer",
           Work::double_loops,
           false,
           {num_cores()},
           [device](AssemblyCase& cells, int threads) {
             cells.clear();
             assemble_offload_transfer(cells.updates, 0, 0, cells.matrix(), device, threads, traffic);
           }},
          {"offload_persistent", Work::double_loops, false, {num_cores()}, [device](AssemblyCase& cells, int threads) {
             assemble_offload_persistent(cells.updates, 0, 0, cells.matrix(), device, threads, traffic);
           }}};
}

std::vector<Rung> own_rungs() {
  return {{"matrix_product",
           Work::products,
           false,
           {1},
           [](AssemblyCase& cells, int) {
             assemble_matrix_product(cells.batch.view(), cells.tables.view(), 0, cells.matrices.data());
           }},
          {"reference_tensor",
           Work::tensors,
           false,
           {1},
           [](AssemblyCase& cells, int) {
             assemble_reference_tensor(cells.batch.view(), cells.tables.view(), 0, cells.matrices.data());
           }},
          {"batched", Work::tensors, true, {1, num_cores()}, [](AssemblyCase& cells, int threads) {
             assemble_batched(cells.batch.view(), cells.tables.view(), cells.num_cells, cells.matrices.data(), threads);
           }}};
}

void register_ladder() {
  std::vector<Rung> rungs = rungs_of_the_thesis();
  const auto append = [&rungs](const std::vector<Rung>& more) { rungs.insert(rungs.end(), more.begin(), more.end()); };
  if (const std::optional<Device> device = benchmark_device("bench_assembly")) append(offload_rungs(*device));
  append(own_rungs());
  for (const int dimension : {1, 2, 3})
    for (int degree = 1; degree <= max_degree; ++degree)
      for (const Rung& rung : rungs)
        for (const int threads : rung.num_threads) {
          const std::string name = std::string("assembly/") + rung.name + "/d:" + std::to_string(dimension + 1) +
                                   "/k:" + std::to_string(degree) + "/threads:" + std::to_string(threads);
          benchmark::RegisterBenchmark(name.c_str(),
                                       [=](benchmark::State& state) { run(state, rung, dimension, degree, threads); })
              ->Unit(benchmark::kMillisecond)
              ->UseRealTime();
        }
}

}  // namespace
}  // namespace tentpole

int main(int argc, char** argv) {
  tentpole::register_ladder();
  return tentpole::run_benchmarks(argc, argv);
}
