#pragma once

#include <cstdint>

#include "host/problem/simulation.hpp"

namespace tentpole {

/// How many tents a run will erect. Floating point: an estimate may be beyond all integers.
struct TentEstimate {
  double patches = 0;
  double elements = 0;
  int largest_patch = 0;  ///< elements
  bool is_exact = false;  ///< all tents were pitched
};

/// Pitches tents without solving them, to the end or until `max_patches` of them; the rest is extrapolated by the
/// share of the spacetime domain that they fill. About 1 us per tent.
TentEstimate estimate_tents(const Simulation& simulation, std::int64_t max_patches);

}  // namespace tentpole
