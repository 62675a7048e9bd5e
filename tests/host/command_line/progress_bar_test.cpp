#include "host/command_line/progress_bar.hpp"

#include <gtest/gtest.h>

namespace tentpole {
namespace {

Progress progress_at(double front_time, std::int64_t patches) {
  Progress progress;
  progress.front_time = front_time;
  progress.end_time = 4.0;
  progress.patches = patches;
  progress.cells = 1640;
  return progress;
}

TEST(ProgressRates, AreCountedFromTheFirstReport) {
  // 3000 patches and a quarter of the time range in 2 s; half of the range is left.
  const ProgressRates rates = progress_rates(progress_at(1.0, 500), progress_at(2.0, 3500), 2.0);
  EXPECT_DOUBLE_EQ(rates.patches_per_second, 1500);
  ASSERT_TRUE(rates.seconds_left);
  EXPECT_DOUBLE_EQ(*rates.seconds_left, 4.0);
}

TEST(ProgressRates, GiveNoForecastBeforeTheFrontHasMovedAndAtTheEnd) {
  EXPECT_FALSE(progress_rates(progress_at(0, 10), progress_at(0, 20), 1.0).seconds_left);
  EXPECT_FALSE(progress_rates(progress_at(0, 10), progress_at(4.0, 20), 1.0).seconds_left);
}

TEST(ProgressRates, OfNoElapsedTimeAreZero) {
  const ProgressRates rates = progress_rates(progress_at(0, 0), progress_at(1.0, 100), 0);
  EXPECT_EQ(rates.patches_per_second, 0);
  EXPECT_FALSE(rates.seconds_left);
}

TEST(ProgressLine, ShowsTimeRateCellsAndForecast) {
  EXPECT_EQ(progress_text(progress_at(1.0, 3500), {12345.4, 11.2}),
            " 25.0 %  t = 1 s  12,345 patches/s  1,640 cells  12 s left");
  EXPECT_EQ(progress_text(progress_at(4.0, 3500), {12345.4, std::nullopt}),
            "100.0 %  t = 4 s  12,345 patches/s  1,640 cells");
}

TEST(ProgressLine, BarIsFilledInProportionAndTheLineFitsTheTerminal) {
  const std::string line = progress_line(progress_at(1.0, 3500), {12345.4, 11.2}, 81);
  EXPECT_EQ(line, "[#####...............]  25.0 %  t = 1 s  12,345 patches/s  1,640 cells  12 s left");
  for (int width = 0; width <= 200; ++width)
    EXPECT_LE(static_cast<int>(progress_line(progress_at(3.99, 3500), {12345.4, 11.2}, width).size()), width);
}

TEST(ProgressLine, StaysInRangeWhenTheFrontOvershootsByRounding) {
  EXPECT_EQ(progress_text(progress_at(4.0000001, 1), {1, std::nullopt}).substr(0, 8), "100.0 % ");
}

}  // namespace
}  // namespace tentpole
