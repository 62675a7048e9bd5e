#include "host/output/output_times.hpp"

#include <cmath>
#include <stdexcept>

namespace tentpole {

std::vector<double> equally_spaced_times(int num_intervals, double end) {
  if (num_intervals < 1 || !(end > 0))
    throw std::invalid_argument("output times: " + std::to_string(num_intervals) + " intervals up to " +
                                std::to_string(end) + " s; both must be positive");
  std::vector<double> times;
  for (int i = 0; i < num_intervals; ++i) times.push_back(end * i / num_intervals);
  times.push_back(end);
  return times;
}

std::vector<double> times_at_interval(double interval, double end) {
  if (!(interval > 0) || !(end > 0))
    throw std::invalid_argument("output interval " + std::to_string(interval) + " s and end " + std::to_string(end) +
                                " s must be positive");
  // A last step shorter than a millionth of the interval is rounding, not a wish.
  const double num_intervals = std::ceil(end / interval - 1e-6);
  std::vector<double> times;
  for (double i = 0; i < num_intervals; ++i) times.push_back(i * interval);
  times.push_back(end);
  return times;
}

void check_output_times(const std::vector<double>& times, const std::string& owner) {
  for (std::size_t i = 0; i < times.size(); ++i)
    if (!(times[i] >= 0) || (i > 0 && !(times[i] > times[i - 1])))
      throw std::invalid_argument(
          owner + ": output time " + std::to_string(i + 1) +
          " is negative or not later than the one before; list times in ascending order from 0");
}

}  // namespace tentpole
