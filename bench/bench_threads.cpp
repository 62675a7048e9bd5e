// Threads: the thesis's way (rows of one matrix) and ours (patches), on the host and on a device.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include <benchmark/benchmark.h>

#include "bench/assembly/device_rows.hpp"
#include "bench/assembly/rungs.hpp"
#include "bench/assembly/sample_updates.hpp"
#include "bench/checked_answer.hpp"
#include "bench/machine_peaks.hpp"
#include "bench/patch_run.hpp"
#include "bench/repeat_timed.hpp"
#include "bench/run_benchmarks.hpp"
#include "bench/sample_patches.hpp"
#include "bench/thread_speedups.hpp"

namespace tentpole {
namespace {

constexpr int num_updates = 100;  // the thesis averages over a hundred
constexpr int num_patches = 64;
constexpr int chunk = 4;  // patches that a thread takes at a time (kernels/launch/patch_solver.cpp)

/// 100 updates of one matrix, rows over threads.
class HostRows {
 public:
  explicit HostRows(const SampleUpdates& updates) : updates_(updates), matrix_(updates.expected().size()) {}

  void run(int num_threads) {
    std::fill(matrix_.begin(), matrix_.end(), 0.0);
    for (int update = 0; update < updates_.size(); ++update)
      add_threaded_rows(updates_.rows(update), {matrix_.data(), updates_.num_unknowns()}, num_threads);
  }
  double error() { return relative_difference(matrix_, updates_.expected()); }

 private:
  const SampleUpdates& updates_;
  std::vector<double> matrix_;
};

/// The same with matrix and rows on a device.
class OffloadedRows {
 public:
  OffloadedRows(const SampleUpdates& updates, const Device& device)
      : updates_(updates), device_(device), matrix_(device, traffic_, std::ssize(updates.expected())) {
    matrix_.upload(std::vector<double>(updates.expected().size(), 0.0));
    for (int update = 0; update < updates.size(); ++update) {
      rows_.emplace_back(updates.element(), device, traffic_);
      on_device_.push_back(rows_.back().upload(updates.rows(update)));
      on_device_.back().block = matrix_.pointer();
    }
  }

  void run(int num_threads) {
    for (const DeviceUpdate& update : on_device_) add_on_device(update, device_, num_threads);
    ++num_runs_;
  }
  double error() {
    std::vector<double> matrix(updates_.expected().size());
    matrix_.download(matrix);
    for (double& entry : matrix) entry /= num_runs_;
    return relative_difference(matrix, updates_.expected());
  }

 private:
  const SampleUpdates& updates_;
  Device device_;
  TrafficCounters traffic_;
  DeviceBuffer<double> matrix_;
  std::vector<DeviceRows> rows_;
  std::vector<DeviceUpdate> on_device_;
  int num_runs_ = 0;
};

ThreadSpeedups& speedups() {
  static ThreadSpeedups kept;
  return kept;
}

/// u / p of the thesis: iterations left over when num_iterations are dealt to p threads.
double imbalance(int num_iterations, int num_threads) {
  return static_cast<double>(num_iterations % num_threads) / num_threads;
}

/// Times `work.run(threads)`, checks its answer and reports.
template <class Work>
void measure(benchmark::State& state, const std::string& what, int num_threads, double limit, Work& work) {
  work.run(num_threads);
  const double seconds = repeat_timed(state, [&] { return seconds_of([&] { work.run(num_threads); }); });
  state.counters["error"] = require_answer("bench_threads: " + what, work.error(), limit);
  const ThreadGain gain = speedups().gain(what, num_threads, seconds, [&] {
    work.run(1);
    return seconds_of([&] { work.run(1); });
  });
  state.counters["speedup"] = gain.speedup;
  state.counters["efficiency"] = gain.efficiency;
}

template <class Rows, class... Where>
void run_rows(benchmark::State& state, const std::string& name, int degree, int num_threads, const Where&... where) {
  const SampleUpdates& updates = sample_updates(degree, num_updates);
  Rows rows(updates, where...);
  measure(state, name, num_threads, 1e-12, rows);
  state.counters["n"] = updates.num_unknowns();
  state.counters["imbalance"] = imbalance(updates.num_unknowns(), num_threads);
  state.counters["GF/s"] = benchmark::Counter(updates.flops() * 1e-9, benchmark::Counter::kIsIterationInvariantRate);
}

/// The batch of the running benchmark.
const TentBatch& batch_of(int dimension, int degree) {
  static TentBatch current;
  if (current.dimension != dimension || current.degree != degree)
    current = sample_patches(dimension, degree, dimension + 1, num_patches);
  return current;
}

/// A batch of patches; each number of threads has its own scratch.
class Patches {
 public:
  Patches(int dimension, int degree, const Device& device) : batch_(batch_of(dimension, degree)), device_(device) {}

  void run(int num_threads) {
    if (!run_ || num_threads != num_threads_) run_ = std::make_unique<PatchRun>(batch_, device_, shape_of(num_threads));
    num_threads_ = num_threads;
    run_->solve();
  }
  double error() { return run_->error(); }

 private:
  /// Threads, or as many teams of a GPU.
  LaunchShape shape_of(int num_workers) const { return {num_workers, device_shape(device_, 0).lanes}; }

  const TentBatch& batch_;
  Device device_;
  std::unique_ptr<PatchRun> run_;
  int num_threads_ = 0;
};

void run_patches(benchmark::State& state, const std::string& name, int dimension, int degree, const Device& device,
                 int num_threads) {
  Patches patches(dimension, degree, device);
  measure(state, name, num_threads, 1e-9, patches);
  state.counters["n"] = dimension * num_polynomials(dimension + 1, degree);
  state.counters["imbalance"] = imbalance(num_patches / chunk, num_threads);
  state.counters["patches/s"] = benchmark::Counter(num_patches, benchmark::Counter::kIsIterationInvariantRate);
}

template <class Run>
void add(const std::string& name, int num_threads, Run run) {
  const std::string full_name = "threads/" + name + "/threads:" + std::to_string(num_threads);
  benchmark::RegisterBenchmark(full_name.c_str(), run)->Unit(benchmark::kMillisecond)->UseManualTime();
}

void register_rows(int degree, int num_threads, const std::optional<Device>& device) {
  const std::string size = "/d:4/k:" + std::to_string(degree);
  add("rows" + size, num_threads,
      [=](benchmark::State& state) { run_rows<HostRows>(state, "rows" + size, degree, num_threads); });
  if (device)
    add("device_rows" + size, num_threads, [=](benchmark::State& state) {
      run_rows<OffloadedRows>(state, "device_rows" + size, degree, num_threads, *device);
    });
}

void register_patches(int dimension, int degree, int num_threads, const std::optional<Device>& device) {
  const std::string size = "/d:" + std::to_string(dimension + 1) + "/k:" + std::to_string(degree);
  add("patches" + size, num_threads, [=](benchmark::State& state) {
    run_patches(state, "patches" + size, dimension, degree, host_device(), num_threads);
  });
  if (device)
    add("device_patches" + size, num_threads, [=](benchmark::State& state) {
      run_patches(state, "device_patches" + size, dimension, degree, *device, num_threads);
    });
}

void register_sweeps() {
  const std::optional<Device> device = benchmark_device("bench_threads");
  for (int degree = 1; degree <= max_degree; ++degree)
    for (int threads = 1; threads <= 2 * num_cores(); ++threads) register_rows(degree, threads, device);
  for (int degree = 1; degree <= max_degree; ++degree)
    for (int threads = 1; threads <= 2 * num_cores(); ++threads) register_patches(2, degree, threads, device);
  for (int degree = 1; degree <= 3; ++degree)
    for (int threads = 1; threads <= 2 * num_cores(); ++threads) register_patches(3, degree, threads, device);
}

}  // namespace
}  // namespace tentpole

int main(int argc, char** argv) {
  tentpole::register_sweeps();
  return tentpole::run_benchmarks(argc, argv);
}
