#pragma once

#include <map>
#include <string>

namespace tentpole {

/// Speedup and efficiency of the threads of one operation, against its one-thread time of the same run.
struct ThreadGain {
  double speedup;     ///< T_1 / T_p
  double efficiency;  ///< speedup / p
};

/// Keeps the one-thread times of a run by the name of the operation and its sizes.
class ThreadSpeedups {
 public:
  /// seconds: of one repetition with num_threads threads. With one thread it becomes the base; where a filter left the
  /// one-thread benchmark out, `measure_one_thread` is called for it once.
  template <class Measure>
  ThreadGain gain(const std::string& operation, int num_threads, double seconds, Measure measure_one_thread) {
    if (num_threads == 1) one_thread_[operation] = seconds;
    auto base = one_thread_.find(operation);
    if (base == one_thread_.end()) base = one_thread_.emplace(operation, measure_one_thread()).first;
    const double speedup = base->second / seconds;
    return {speedup, speedup / num_threads};
  }

 private:
  std::map<std::string, double> one_thread_;  ///< [s]
};

}  // namespace tentpole
