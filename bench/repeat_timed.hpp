#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

#include <benchmark/benchmark.h>

namespace tentpole {

/// Wall time of one call [s].
template <class Work>
double seconds_of(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count();
}

/// Repeats `work` as often as Google Benchmark asks; `work` returns the time that counts [s], which becomes the
/// iteration's (register with UseManualTime). Returns the median of these times.
template <class Work>
double repeat_timed(benchmark::State& state, Work work) {
  std::vector<double> times;
  for (auto _ : state) {
    times.push_back(work());
    state.SetIterationTime(times.back());
  }
  std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
  return times[times.size() / 2];
}

}  // namespace tentpole
