// Traffic: 100 updates of a cell matrix on the host, and on a device with everything transferred each time, with the
// matrix kept there, and with the next rows formed and uploaded while the device works.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "bench/assembly/device_rows.hpp"
#include "bench/assembly/rungs.hpp"
#include "bench/assembly/sample_updates.hpp"
#include "bench/checked_answer.hpp"
#include "bench/machine_peaks.hpp"
#include "bench/repeat_timed.hpp"
#include "bench/run_benchmarks.hpp"
#include "device/work_queue.hpp"

namespace tentpole {
namespace {

constexpr int num_updates = 100;

enum class Mode { host, transfer, persistent, overlapped };
constexpr std::array<std::pair<Mode, const char*>, 4> modes{{{Mode::host, "host"},
                                                             {Mode::transfer, "transfer"},
                                                             {Mode::persistent, "persistent"},
                                                             {Mode::overlapped, "overlapped"}}};

/// One way of running all updates, and what it cost so far.
class UpdateRun {
 public:
  UpdateRun(const SampleUpdates& updates, const Device& device)
      : updates_(updates),
        device_(device),
        rows_{DeviceRows(updates.element(), device, traffic), DeviceRows(updates.element(), device, traffic)},
        block_(device, traffic, std::ssize(updates.expected())),
        matrix_(updates.expected().size()),
        scratch_(updates.element().scratch_size()) {}

  void run(Mode mode) {
    std::fill(matrix_.begin(), matrix_.end(), 0.0);
    switch (mode) {
      case Mode::host:
        return run_on_host();
      case Mode::transfer:
        return run_with_transfer();
      case Mode::persistent:
        return run_persistent();
      case Mode::overlapped:
        return run_overlapped();
    }
  }

  double error() const { return relative_difference(matrix_, updates_.expected()); }

  TrafficCounters traffic;
  double transfer_seconds = 0;  ///< in copies; with overlap, partly while the device works

 private:
  void run_on_host() {
    for (int update = 0; update < updates_.size(); ++update)
      add_threaded_rows(updates_.form(update, scratch_.data()), {matrix_.data(), updates_.num_unknowns()}, num_cores());
  }

  DeviceUpdate upload_rows(int update) {
    const UpdateRows rows = updates_.form(update, scratch_.data());
    DeviceUpdate on_device;
    transfer_seconds += seconds_of([&] { on_device = rows_[update % 2].upload(rows); });
    on_device.block = block_.pointer();
    return on_device;
  }
  void upload_matrix() {
    transfer_seconds += seconds_of([&] { block_.upload(matrix_); });
  }
  void download_matrix() {
    transfer_seconds += seconds_of([&] { block_.download(matrix_); });
  }
  void launch(const DeviceUpdate& on_device) {
    add_on_device(on_device, device_, num_cores());
    traffic.count_launch(sizeof on_device);
  }

  void run_with_transfer() {
    for (int update = 0; update < updates_.size(); ++update) {
      const DeviceUpdate on_device = upload_rows(update);
      upload_matrix();
      launch(on_device);
      download_matrix();
    }
  }

  void run_persistent() {
    upload_matrix();
    for (int update = 0; update < updates_.size(); ++update) launch(upload_rows(update));
    download_matrix();
  }

  void run_overlapped() {
    upload_matrix();
    DeviceUpdate on_device = upload_rows(0);
    for (int update = 0; update < updates_.size(); ++update) {
      queue_.submit([this, on_device] { launch(on_device); });
      if (update + 1 < updates_.size()) on_device = upload_rows(update + 1);
      queue_.wait();
    }
    download_matrix();
  }

  const SampleUpdates& updates_;
  Device device_;
  std::array<DeviceRows, 2> rows_;  ///< updates take turns, so that one can be filled while the other is read
  DeviceBuffer<double> block_;
  std::vector<double> matrix_;
  std::vector<double> scratch_;
  WorkQueue queue_;
};

/// Median times of this run [s], by mode and degree.
std::map<std::pair<Mode, int>, double>& measured_times() {
  static std::map<std::pair<Mode, int>, double> times;
  return times;
}

std::string name_of(Mode mode) {
  return std::find_if(modes.begin(), modes.end(), [mode](const auto& each) { return each.first == mode; })->second;
}

void check(const UpdateRun& run, Mode mode, int degree) {
  require_answer("bench_traffic: " + name_of(mode) + ", d = 4, k = " + std::to_string(degree), run.error(), 1e-12);
}

void run_mode(benchmark::State& state, Mode mode, int degree, const Device& device) {
  const SampleUpdates& updates = sample_updates(degree, num_updates);
  UpdateRun warm_up(updates, device), run(updates, device);
  warm_up.run(mode);
  double all_seconds = 0;
  const double seconds = repeat_timed(state, [&] {
    const double time = seconds_of([&] { run.run(mode); });
    all_seconds += time;
    return time;
  });
  check(run, mode, degree);
  measured_times()[{mode, degree}] = seconds;
  const double repetitions = static_cast<double>(state.iterations());
  state.counters["n"] = updates.num_unknowns();
  state.counters["bytes_up"] = static_cast<double>(run.traffic.bytes_to_device) / repetitions;
  state.counters["bytes_down"] = static_cast<double>(run.traffic.bytes_from_device) / repetitions;
  state.counters["launches"] = static_cast<double>(run.traffic.launches) / repetitions;
  state.counters["transfer_s"] = run.transfer_seconds / repetitions;
  state.counters["transfer_%"] = 100 * run.transfer_seconds / all_seconds;
  state.counters["GF/s"] = updates.flops() / seconds * 1e-9;
  state.counters["error"] = run.error();
}

/// From this run, or measured now (median of three) where a filter left the benchmark out.
double time_of(Mode mode, int degree, const Device& device) {
  auto found = measured_times().find({mode, degree});
  if (found != measured_times().end()) return found->second;
  UpdateRun run(sample_updates(degree, num_updates), device);
  run.run(mode);
  check(run, mode, degree);
  std::array<double, 3> times;
  for (double& time : times) time = seconds_of([&] { run.run(mode); });
  std::sort(times.begin(), times.end());
  return measured_times()[{mode, degree}] = times[1];
}

/// Smallest degree from which on the first mode beats the second for all larger ones; 0 if it loses at k = 7.
void run_break_even(benchmark::State& state, Mode first, Mode second, const Device& device) {
  int degree = 0;
  double ratio = 0;
  for (auto _ : state) {
    degree = 0;
    for (int k = max_degree; k >= 1; --k) {
      const double first_time = time_of(first, k, device), second_time = time_of(second, k, device);
      if (k == max_degree) ratio = second_time / first_time;
      if (first_time >= second_time) break;
      degree = k;
    }
    state.SetIterationTime(1e-9);  // nothing is timed here
  }
  state.counters["k"] = degree;
  state.counters["n"] = degree == 0 ? 0 : 3 * num_polynomials(4, degree);
  state.counters["ratio_k7"] = ratio;
}

void register_break_even(Mode first, Mode second, const Device& device) {
  const std::string name = "traffic/break_even/" + name_of(first) + "_against_" + name_of(second) + "/d:4";
  benchmark::RegisterBenchmark(name.c_str(),
                               [=](benchmark::State& state) { run_break_even(state, first, second, device); })
      ->Iterations(1)
      ->UseManualTime();
}

void register_modes(const Device& device) {
  for (int degree = 1; degree <= max_degree; ++degree)
    for (const auto& [mode, mode_name] : modes) {
      const std::string name = std::string("traffic/") + mode_name + "/d:4/k:" + std::to_string(degree) +
                               "/threads:" + std::to_string(num_cores());
      const Mode chosen = mode;
      benchmark::RegisterBenchmark(name.c_str(),
                                   [=](benchmark::State& state) { run_mode(state, chosen, degree, device); })
          ->Unit(benchmark::kMillisecond)
          ->UseManualTime();
    }
  register_break_even(Mode::persistent, Mode::transfer, device);
  register_break_even(Mode::transfer, Mode::host, device);
  register_break_even(Mode::persistent, Mode::host, device);
  register_break_even(Mode::overlapped, Mode::persistent, device);
}

}  // namespace
}  // namespace tentpole

int main(int argc, char** argv) {
  const std::optional<tentpole::Device> device = tentpole::benchmark_device("bench_traffic");
  if (!device) return 0;
  tentpole::register_modes(*device);
  return tentpole::run_benchmarks(argc, argv);
}
