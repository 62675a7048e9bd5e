#pragma once

#include <algorithm>
#include <span>

namespace tentpole {

/// True where an element with time range [time_min, time_max] answers for `time`: time_min < time <= time_max, or
/// time == 0 == time_min. So a flat front at an output time is covered once, by the elements below it.
constexpr bool covers(double time_min, double time_max, double time) {
  return (time_min < time && time <= time_max) || (time == 0 && time_min == 0);
}

/// True once no later element can cover `time`, when the lowest front vertex is at `front_minimum` [s].
constexpr bool front_has_passed(double front_minimum, double time) {
  return time < front_minimum || (time > 0 && time <= front_minimum);
}

/// Output times first..last-1.
struct OutputRange {
  int first;
  int last;
  bool empty() const { return first >= last; }
};

/// The output times (strictly ascending, >= 0) that an element with this time range covers.
inline OutputRange covered_times(std::span<const double> times, double time_min, double time_max) {
  int first = static_cast<int>(std::upper_bound(times.begin(), times.end(), time_min) - times.begin());
  const int last = static_cast<int>(std::upper_bound(times.begin(), times.end(), time_max) - times.begin());
  if (first == 1 && times[0] == 0 && time_min == 0) first = 0;
  return {first, last};
}

}  // namespace tentpole
