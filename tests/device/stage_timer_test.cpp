#include "device/stage_timer.hpp"

#include <set>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

TEST(StageTimer, SumsWhatIsAddedToEachStage) {
  StageTimer timer;
  timer.add(Stage::meshing, milliseconds(20));
  timer.add(Stage::meshing, milliseconds(5));
  timer.add(Stage::total, milliseconds(100));
  EXPECT_DOUBLE_EQ(timer.seconds(Stage::meshing), 0.025);
  EXPECT_DOUBLE_EQ(timer.percent(Stage::meshing), 25);
  EXPECT_EQ(timer.seconds(Stage::output), 0);
}

TEST(StageTimer, PercentOfNothingIsZero) {
  StageTimer timer;
  timer.add(Stage::output, milliseconds(1));
  EXPECT_EQ(timer.percent(Stage::output), 0);
}

TEST(StageTimer, ThreadsLoseNoTime) {
  StageTimer timer;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int k = 0; k < 10000; ++k) timer.add(Stage::solution, nanoseconds(100));
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_DOUBLE_EQ(timer.seconds(Stage::solution), 4e-3);
}

TEST(StageTimer, ScopeAddsItsDuration) {
  StageTimer timer;
  const auto start = std::chrono::steady_clock::now();
  {
    const ScopedStage scope(timer, Stage::transfer);
    std::this_thread::sleep_for(milliseconds(2));
  }
  const double outside = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_GE(timer.seconds(Stage::transfer), 2e-3);
  EXPECT_LE(timer.seconds(Stage::transfer), outside);
}

TEST(StageTimer, StagesHaveDistinctNames) {
  std::set<std::string> names;
  for (int stage = 0; stage < num_stages; ++stage) names.insert(stage_name(static_cast<Stage>(stage)));
  EXPECT_EQ(static_cast<int>(names.size()), num_stages);
  EXPECT_EQ(names.count("unknown stage"), 0u);
}

}  // namespace
}  // namespace tentpole
