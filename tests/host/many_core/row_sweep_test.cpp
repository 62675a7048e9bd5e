#include "host/many_core/row_sweep.hpp"

#include <gtest/gtest.h>

namespace tentpole {
namespace {

/// Four cores; a vector takes 1 s, a row of 8 doubles has 4 vectors and 64 B; nothing else costs anything.
Machine plain_machine() {
  Machine machine;
  machine.cores = {4, 0, 2, 2, 1.0};
  machine.cache = {1e6, 1e30, 1e30};
  machine.translation = {64, 4096, 0.0};
  machine.loop.added = {0.0};
  return machine;
}

TEST(RowSweep, BusiestThreadSetsTheTime) {
  const Machine machine = plain_machine();
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 1), 8 * 4);
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 3), 3 * 4);  // 3 + 3 + 2 rows
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 4), 2 * 4);
}

TEST(RowSweep, RowsEndWithAPartlyFilledVector) {
  EXPECT_DOUBLE_EQ(pass_time(plain_machine(), 7, 1), 7 * 4);
}

TEST(RowSweep, ThreadsOfACoreShareIt) {
  EXPECT_DOUBLE_EQ(pass_time(plain_machine(), 8, 5), (2 + 1) * 4);  // 2 2 2 1 1: the fifth is on the first core
  EXPECT_DOUBLE_EQ(pass_time(plain_machine(), 8, 8), 2 * 4);
}

TEST(RowSweep, SystemCoreDoesNotWork) {
  Machine machine = plain_machine();
  machine.cores.system = 1;
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 4), (2 + 2) * 4);
}

TEST(RowSweep, MissesWaitForThoseOfEveryOtherCore) {
  Machine machine = plain_machine();
  machine.cache = {3 * 64, 64, 32};  // holds 3 rows; a row takes 1 s alone and 2 s more for each other core that misses
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 1), 8 * 4 + 8 * 1);
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 2), 4 * 4 + 4 * (1 + 2));
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 3), 3 * 4);  // 3 rows fit
}

TEST(RowSweep, NewMatrixIsAlwaysMissed) {
  Machine machine = plain_machine();
  machine.cache = {1e6, 64, 1e30};
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 1), 8 * 4);
  machine.loop.keeps_matrix = false;
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 1), 8 * 4 + 8);
}

TEST(RowSweep, AddedMatrixIsFetchedAndTakesCache) {
  Machine machine = plain_machine();
  machine.cache = {1e6, 64, 1e30};
  machine.loop.added = {0.0, 1.0};
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 1), 8 * 4 + 0.5 * 8);
  machine.cache.private_bytes = 8 * 64;  // the matrix alone: the rows of the pass that adds push it out
  EXPECT_GT(pass_time(machine, 8, 1), 8 * 4 + 0.5 * 8);
}

TEST(RowSweep, PagesBeyondTheTranslationsAreWalked) {
  Machine machine = plain_machine();
  machine.translation = {7, 64, 0.25};
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 1), 8 * 4 + 8 * 0.25);
  machine.translation.entries = 8;
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 1), 8 * 4);
}

TEST(RowSweep, ForkAndJoinCostTeamsOnly) {
  Machine machine = plain_machine();
  machine.fork_join = {100, 10, 0, 1000};
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 1), 8 * 4);
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 4), 2 * 4 + 100 + 40);
  // 16 rows of 8 vectors on 10 threads: 6 of them with 2 rows, the first core has 3 threads with 2 + 2 + 1 rows
  EXPECT_DOUBLE_EQ(pass_time(machine, 16, 10), 5 * 8 + 100 + 100 + 2 * 1000);
}

TEST(RowSweep, ThreadsEnterTheJoinOneAfterTheOther) {
  Machine machine = plain_machine();
  machine.fork_join.arrival = 0.5;
  EXPECT_DOUBLE_EQ(pass_time(machine, 8, 4), 2 * 4 + 4 * 0.5);  // all at once
  EXPECT_DOUBLE_EQ(pass_time(machine, 9, 4), 3 * 5 + 0.5);      // three of them enter while one has a row left
}

TEST(RowSweep, ReportsSpeedupEfficiencyAndImbalance) {
  const std::vector<SweepPoint> points = model_sweep(plain_machine(), 8, {1, 3});
  ASSERT_EQ(points.size(), 2u);
  EXPECT_DOUBLE_EQ(points[0].speedup, 1);
  EXPECT_DOUBLE_EQ(points[1].speedup, 32.0 / 12);
  EXPECT_DOUBLE_EQ(points[1].efficiency, 32.0 / 36);
  EXPECT_DOUBLE_EQ(points[1].imbalance, 2.0 / 3);
}

TEST(RowSweep, MoreThreadsThanRowsLeaveSomeIdle) {
  EXPECT_DOUBLE_EQ(pass_time(plain_machine(), 2, 4), 1);
}

}  // namespace
}  // namespace tentpole
