#pragma once

#include <string>
#include <vector>

namespace tentpole {

/// 0, end/n, .., end: n + 1 times, the last one exactly `end` [s]. `snapshots = n` in a case file means these.
std::vector<double> equally_spaced_times(int num_intervals, double end);

/// 0, interval, 2 interval, .., end; the last step is shorter where `interval` does not divide `end` [s].
/// Throws std::invalid_argument unless 0 < interval and 0 < end.
std::vector<double> times_at_interval(double interval, double end);

/// Throws std::invalid_argument that names `owner` unless the times are >= 0 and strictly ascending.
void check_output_times(const std::vector<double>& times, const std::string& owner);

}  // namespace tentpole
