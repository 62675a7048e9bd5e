#include "host/many_core/calibrate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <omp.h>

#include "host/many_core/row_update.hpp"
#include "host/many_core/system_caches.hpp"
#include "host/output/machine_info.hpp"

namespace tentpole {
namespace {

constexpr int num_rows = calibration_rows, num_terms = 3;
constexpr double no_limit = 1e15;  // [B/s] where no time is left for the transfer: it is hidden

#if defined(__AVX512F__)
constexpr int vector_length = 8;
#elif defined(__AVX__)
constexpr int vector_length = 4;
#else
constexpr int vector_length = 2;
#endif

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The time that one call in ten beats: other programs disturb the longer ones.
double undisturbed(std::vector<double> values) {
  const auto place = values.begin() + static_cast<long>(values.size() / 10);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// Undisturbed time of one call [s], after a warm-up call.
template <class Work>
double time_of(int repetitions, Work work) {
  work();
  std::vector<double> seconds;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    const auto start = std::chrono::steady_clock::now();
    work();
    seconds.push_back(seconds_since(start));
  }
  return undisturbed(std::move(seconds));
}

/// A cell matrix and the vectors of one update, all in ordinary memory.
class SampleUpdate {
 public:
  explicit SampleUpdate(int rows)
      : test_(static_cast<std::size_t>(num_terms) * rows, 1e-3),
        trial_(test_.size(), 1e-3),
        matrix_(static_cast<std::size_t>(rows) * rows),
        update_{rows, num_terms, test_.data(), trial_.data(), matrix_.data()} {}
  const RowUpdate& update() const { return update_; }

 private:
  std::vector<double> test_, trial_, matrix_;
  RowUpdate update_;
};

/// With four significant digits: more were not measured.
double rounded(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.3e", value);
  return std::strtod(digits, nullptr);
}

double bytes_per_second(double seconds_per_byte) {
  return seconds_per_byte > 1 / no_limit ? rounded(1 / seconds_per_byte) : no_limit;
}

/// Time of a row [s] while all cores stream shares of a matrix of their own: what the slowest of them takes.
double shared_row_time(int cores) {
  constexpr int passes = 400;
  const int share = num_rows / 2;
  std::vector<double> row_times(static_cast<std::size_t>(cores));
#pragma omp parallel num_threads(cores)
  {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    const SampleUpdate own(num_rows);  // its pages are near the core that first writes them
    std::vector<double> times;
#pragma omp barrier
    for (int pass = 0; pass < passes; ++pass) {
      const auto start = std::chrono::steady_clock::now();
      update_rows(own.update(), 0, share);
      times.push_back(seconds_since(start) / share);
    }
    row_times[thread] = undisturbed(std::move(times));
  }
  return *std::max_element(row_times.begin(), row_times.end());
}

/// Fork and join of p threads [s]: a loop over one short row per thread.
double fork_join_time(int threads) {
  const SampleUpdate sample(threads);
  return time_of(2000, [&] { update_rows_on_threads(sample.update(), threads); });
}

/// fixed + per_thread p by least squares over p = 2..cores, none of them negative.
ForkJoinParameters fit_fork_join(int cores) {
  ForkJoinParameters result;
  std::vector<double> times;
  for (int threads = 2; threads <= std::max(2, cores); ++threads) times.push_back(fork_join_time(threads));
  double mean_time = 0, mean_threads = 0, covariance = 0, variance = 0;
  const auto count = static_cast<double>(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    mean_time += times[i] / count;
    mean_threads += (static_cast<double>(i) + 2) / count;
  }
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double distance = static_cast<double>(i) + 2 - mean_threads;
    covariance += distance * (times[i] - mean_time);
    variance += distance * distance;
  }
  if (variance > 0) result.per_thread = std::clamp(covariance / variance, 0.0, mean_time / mean_threads);
  result.fixed = rounded(mean_time - result.per_thread * mean_threads);
  result.per_thread = rounded(result.per_thread);
  return result;
}

}  // namespace

Machine calibrate_machine() {
  Machine machine;
  const MachineInfo info = machine_info();
  machine.name = (info.processor.empty() ? std::string("unknown processor") : info.processor) + ", calibrated";
  machine.cores.threads = threads_per_core();
  machine.cores.count = std::max(1, info.cores / machine.cores.threads);
  machine.cores.vector_length = vector_length;
  machine.cache.private_bytes = private_cache_bytes();
  machine.translation.page_bytes = page_bytes();
  machine.loop.added = {0.0};

  const SampleUpdate sample(num_rows);
  const double row_size = 8.0 * num_rows, vectors = std::ceil(static_cast<double>(num_rows) / vector_length);
  const int cached_rows = std::clamp(static_cast<int>(0.5 * machine.cache.private_bytes / row_size), 1, num_rows);
  const double cached = time_of(4000, [&] { update_rows(sample.update(), 0, cached_rows); }) / cached_rows;
  const double alone = time_of(400, [&] { update_rows(sample.update(), 0, num_rows); }) / num_rows;
  machine.cores.vector_time = rounded(cached / vectors);
  machine.cache.core_bandwidth = bytes_per_second((alone - cached) / row_size);
  const int cores = machine.cores.count;
  const double together = cores > 1 ? shared_row_time(cores) : alone;
  machine.cache.shared_bandwidth =
      cores > 1 ? bytes_per_second((together - std::max(alone, cached)) / (row_size * (cores - 1))) : no_limit;

  machine.fork_join = fit_fork_join(cores);
  const int hardware_threads = cores * machine.cores.threads;
  const double crowded = fork_join_time(2 * hardware_threads);
  const double expected = machine.fork_join.fixed + machine.fork_join.per_thread * 2 * hardware_threads;
  machine.fork_join.turn = rounded(std::max(0.0, crowded - expected) / hardware_threads);
  return machine;
}

std::vector<double> measure_sweep(int most_threads) {
  const SampleUpdate sample(num_rows);
  std::vector<double> times;
  for (int threads = 1; threads <= most_threads; ++threads)
    times.push_back(time_of(1000, [&] { update_rows_on_threads(sample.update(), threads); }));
  return times;
}

}  // namespace tentpole
