#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "host/run/run.hpp"

namespace tentpole {

/// Rates since the first report: a resumed run does not start at zero.
struct ProgressRates {
  double patches_per_second = 0;
  std::optional<double> seconds_left;  ///< absent as long as the front has not moved, and at the end
};

ProgressRates progress_rates(const Progress& first, const Progress& now, double elapsed_seconds);

/// "42.3 %  t = 4.23e-08 s  12,345 patches/s  640 cells  12 s left".
std::string progress_text(const Progress& progress, const ProgressRates& rates);

/// The same behind a bar, "[######........]  42.3 %  ...", cut to `width` places; no bar where there is no room.
std::string progress_line(const Progress& progress, const ProgressRates& rates, int width);

/// Shows how far a run is: on a terminal one line, redrawn about 10 times per second; elsewhere a plain line every 5
/// seconds, so that log files stay short; nothing when quiet.
class ProgressBar {
 public:
  enum class Style { silent, terminal, lines };

  explicit ProgressBar(Style style);
  /// Ends the line, so that an error is not printed behind it.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Call after every batch; returns at once if it is not yet time to show something.
  void update(const Progress& progress);
  /// Ends the line on a terminal; call before other output.
  void finish();

  /// What suits stdout: a terminal that can move its cursor, or not.
  static Style style_of_stdout(bool quiet);

 private:
  using Clock = std::chrono::steady_clock;

  void show();

  Style style_;
  Clock::time_point start_;
  std::optional<Clock::time_point> shown_;
  std::optional<Progress> first_;
  Progress last_;
};

}  // namespace tentpole
