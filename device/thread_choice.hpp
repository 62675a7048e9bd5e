#pragma once

#include <optional>
#include <string>

namespace tentpole {

/// What decides how many threads a parallel loop of the host gets.
struct ThreadSupply {
  int usual = 1;                     ///< OMP_NUM_THREADS, or as many as cores that this process may use
  bool is_chosen = false;            ///< by OMP_NUM_THREADS
  int limit = 1;                     ///< OMP_THREAD_LIMIT
  std::optional<double> quota = {};  ///< cores' worth of time (core_quota.hpp)
};

/// That of this process when it was first asked for.
const ThreadSupply& thread_supply();

struct ThreadChoice {
  int threads = 1;
  std::string reason;  ///< why they are fewer than asked for, or more than there are cores for; usually empty
};

/// `requested` threads, or with 0 the usual number, but no more than a quota keeps busy; never more than the limit.
ThreadChoice choose_threads(const ThreadSupply& supply, int requested);

}  // namespace tentpole
