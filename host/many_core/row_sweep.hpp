#pragma once

#include <vector>

#include "host/many_core/machine.hpp"

namespace tentpole {

/// Rows of one cell matrix on p threads, modelled.
struct SweepPoint {
  int threads = 1;
  double time = 0;        ///< one pass over the matrix, mean over the passes of the loop [s]
  double speedup = 1;     ///< time of one thread / time
  double efficiency = 1;  ///< speedup / threads
  double imbalance = 0;   ///< u / p with u = n mod p: near 0 or 1 the threads have equal work
};

/// Time of one pass over the n x n cell matrix (n = `rows`) on p = `threads` threads [s], by these mechanisms:
///
/// - static schedule: n mod p threads have ceil(n / p) rows, the others floor(n / p);
/// - thread t runs on core t mod (usable cores); the threads of a core share its issue slots and its cache;
/// - a row costs ceil(n / vector length) vectors; a core streams its rows (8 n bytes each), and in some passes as many
///   rows of an added matrix, through least-recently-used caches of data and of address translations;
/// - what the data cache misses costs 1 / core_bandwidth + (a - 1) / shared_bandwidth per byte, where a is the
///   number of cores that miss: each transfer waits for one of every other core;
/// - fork and join cost `fixed` + `per_thread` p, and threads are let into the join one after the other.
///
/// Deterministic. n >= 1, p >= 1.    Source: [Marwah 2014], section 3.3, explains its curves by these effects.
double pass_time(const Machine& machine, int rows, int threads);

/// One point per thread count, in the order given.
std::vector<SweepPoint> model_sweep(const Machine& machine, int rows, const std::vector<int>& threads);

}  // namespace tentpole
