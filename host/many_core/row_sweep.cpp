#include "host/many_core/row_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "host/many_core/recency_cache.hpp"

namespace tentpole {
namespace {

/// Rows of each thread of a core, ascending by thread.
using CoreRows = std::vector<int>;

/// The kinds of core loads that occur, and on how many cores each.
std::map<CoreRows, int> distribute(int rows, int threads, int cores) {
  std::vector<CoreRows> of_core(std::min(threads, cores));
  for (int thread = 0; thread < threads; ++thread)
    of_core[thread % cores].push_back(rows / threads + (thread < rows % threads ? 1 : 0));
  std::map<CoreRows, int> kinds;
  for (const CoreRows& core : of_core) ++kinds[core];
  return kinds;
}

double row_bytes(int rows) {
  return 8.0 * rows;
}

/// Streams the rows of a core through a cache of the capacity [B], the threads by turns row by row; returns the bytes
/// that each pass misses. A matrix that is kept is streamed twice before, so that the cache is in its steady state.
std::vector<double> missed_bytes(const LoopParameters& loop, double capacity, const CoreRows& core, double row_size) {
  RecencyCache cache(capacity);
  const int longest = *std::max_element(core.begin(), core.end());
  const auto num_threads = static_cast<std::int64_t>(core.size());
  std::vector<double> missed(loop.added.size());
  std::int64_t matrix = 0, added_block = -1;  // blocks of added matrices are new in each pass
  for (int round = 0; round < (loop.keeps_matrix ? 3 : 1); ++round)
    for (std::size_t pass = 0; pass < loop.added.size(); ++pass) {
      if (!loop.keeps_matrix) matrix += num_threads * longest;
      missed[pass] = 0;
      const double added_size = loop.added[pass] * row_size;
      for (int row = 0; row < longest; ++row)
        for (std::int64_t thread = 0; thread < num_threads; ++thread) {
          if (row >= core[thread]) continue;
          if (!cache.touch(matrix + row * num_threads + thread, row_size)) missed[pass] += row_size;
          if (added_size > 0 && !cache.touch(added_block--, added_size)) missed[pass] += added_size;
        }
    }
  return missed;
}

/// A core between fork and join.
struct CoreWork {
  int num_cores = 0;                   ///< cores with this work
  int num_threads = 0;                 ///< on each of them
  double compute = 0;                  ///< vectors of all its threads [s]
  std::vector<double> missed, walked;  ///< per pass: bytes from memory, bytes of pages to be translated [B]
};

std::vector<CoreWork> core_works(const Machine& machine, int rows, int threads) {
  const double vectors = std::ceil(static_cast<double>(rows) / machine.cores.vector_length);
  const double reach = static_cast<double>(machine.translation.entries) * machine.translation.page_bytes;
  std::vector<CoreWork> works;
  for (const auto& [core, num_cores] : distribute(rows, threads, machine.usable_cores())) {
    int num_rows = 0;
    for (const int each : core) num_rows += each;
    works.push_back({num_cores, static_cast<int>(core.size()), num_rows * vectors * machine.cores.vector_time,
                     missed_bytes(machine.loop, machine.cache.private_bytes, core, row_bytes(rows)),
                     missed_bytes(machine.loop, reach, core, row_bytes(rows))});
  }
  return works;
}

/// When each kind of core is through with a pass [s], and how many threads then come to the join.
std::map<double, int> arrivals(const Machine& machine, const std::vector<CoreWork>& works, std::size_t pass) {
  int missing_cores = 0;
  for (const CoreWork& work : works) missing_cores += work.missed[pass] > 0 ? work.num_cores : 0;
  const double byte_time =
      1 / machine.cache.core_bandwidth + std::max(0, missing_cores - 1) / machine.cache.shared_bandwidth;
  std::map<double, int> threads_at;
  for (const CoreWork& work : works) {
    const double walks = work.walked[pass] / machine.translation.page_bytes;
    const double time = work.compute + work.missed[pass] * byte_time + walks * machine.translation.walk_time;
    threads_at[time] += work.num_cores * work.num_threads;
  }
  return threads_at;
}

/// When the last thread is in, if each takes `arrival` at the door.
double join(const std::map<double, int>& threads_at, double arrival) {
  double door_free = 0;
  for (const auto& [time, num_threads] : threads_at) door_free = std::max(door_free, time) + num_threads * arrival;
  return door_free;
}

double fork_time(const Machine& machine, int threads) {
  const int hardware_threads = machine.usable_cores() * machine.cores.threads;
  return machine.fork_join.fixed + machine.fork_join.per_thread * threads +
         machine.fork_join.turn * std::max(0, threads - hardware_threads);
}

}  // namespace

double pass_time(const Machine& machine, int rows, int threads) {
  const std::vector<CoreWork> works = core_works(machine, rows, threads);
  const bool alone = threads == 1;
  double total = 0;
  for (std::size_t pass = 0; pass < machine.loop.added.size(); ++pass)
    total += join(arrivals(machine, works, pass), alone ? 0 : machine.fork_join.arrival);
  return total / static_cast<double>(machine.loop.added.size()) + (alone ? 0 : fork_time(machine, threads));
}

std::vector<SweepPoint> model_sweep(const Machine& machine, int rows, const std::vector<int>& threads) {
  const double alone = pass_time(machine, rows, 1);
  std::vector<SweepPoint> points;
  for (const int p : threads) {
    const double time = pass_time(machine, rows, p), speedup = alone / time;
    points.push_back({p, time, speedup, speedup / p, static_cast<double>(rows % p) / p});
  }
  return points;
}

}  // namespace tentpole
