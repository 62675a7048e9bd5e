#include "host/command_line/progress_bar.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <sys/ioctl.h>
#include <unistd.h>

#include "host/command_line/quantity.hpp"

namespace tentpole {
namespace {

using Seconds = std::chrono::duration<double>;

int terminal_width() {
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

double fraction_done(const Progress& progress) {
  return progress.end_time > 0 ? std::clamp(progress.front_time / progress.end_time, 0.0, 1.0) : 0;
}

/// A forecast is not worth fractions of a second.
std::string whole_seconds(double seconds) {
  return seconds < 59 ? count_text(std::llround(std::ceil(seconds))) + " s" : duration_text(seconds);
}

}  // namespace

ProgressRates progress_rates(const Progress& first, const Progress& now, double elapsed_seconds) {
  ProgressRates rates;
  if (!(elapsed_seconds > 0)) return rates;
  rates.patches_per_second = static_cast<double>(now.patches - first.patches) / elapsed_seconds;
  if (now.front_time > first.front_time && now.front_time < now.end_time)
    rates.seconds_left = (now.end_time - now.front_time) / (now.front_time - first.front_time) * elapsed_seconds;
  return rates;
}

std::string progress_text(const Progress& progress, const ProgressRates& rates) {
  char start[64];
  std::snprintf(start, sizeof start, "%5.1f %%  t = %.3g s  ", 100 * fraction_done(progress), progress.front_time);
  std::string text = start + count_text(std::llround(rates.patches_per_second)) + " patches/s  " +
                     count_text(progress.cells) + " cells";
  if (rates.seconds_left) text += "  " + whole_seconds(*rates.seconds_left) + " left";
  return text;
}

std::string progress_line(const Progress& progress, const ProgressRates& rates, int width) {
  const std::string text = progress_text(progress, rates);
  constexpr int longest_bar = 40, shortest_bar = 5;
  const int room = std::min(width - static_cast<int>(text.size()) - 3, longest_bar);
  if (room < shortest_bar) return text.substr(0, std::max(width, 0));
  const int filled = static_cast<int>(std::floor(room * fraction_done(progress)));
  return "[" + std::string(filled, '#') + std::string(room - filled, '.') + "] " + text;
}

ProgressBar::ProgressBar(Style style) : style_(style), start_(Clock::now()) {}

ProgressBar::~ProgressBar() {
  finish();
}

void ProgressBar::update(const Progress& progress) {
  if (!first_) {
    // The first report comes when the first batch is done: from there on rates are meaningful, also of a resumed run.
    first_ = progress;
    start_ = Clock::now();
    if (style_ == Style::lines) shown_ = start_;
  }
  last_ = progress;
  const Seconds interval(style_ == Style::terminal ? 0.1 : 5.0);
  if (style_ == Style::silent || (shown_ && Clock::now() - *shown_ < interval)) return;
  show();
}

void ProgressBar::show() {
  shown_ = Clock::now();
  const ProgressRates rates = progress_rates(*first_, last_, Seconds(*shown_ - start_).count());
  if (style_ == Style::terminal) {
    // One place is left free: a full line would wrap. "\033[K" clears what a longer line left behind.
    std::printf("\r%s\033[K", progress_line(last_, rates, terminal_width() - 1).c_str());
  } else {
    std::printf("%s\n", progress_text(last_, rates).c_str());
  }
  std::fflush(stdout);
}

void ProgressBar::finish() {
  if (style_ != Style::terminal || !first_) return;
  show();
  std::printf("\n");
  std::fflush(stdout);
  first_.reset();
}

ProgressBar::Style ProgressBar::style_of_stdout(bool quiet) {
  if (quiet) return Style::silent;
  const char* terminal = std::getenv("TERM");
  const bool can_redraw = isatty(STDOUT_FILENO) && terminal != nullptr && std::strcmp(terminal, "dumb") != 0;
  return can_redraw ? Style::terminal : Style::lines;
}

}  // namespace tentpole
