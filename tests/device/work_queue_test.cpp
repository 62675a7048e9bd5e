#include "device/work_queue.hpp"

#include <chrono>
#include <future>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

TEST(WorkQueue, RunsTasksInTheOrderOfSubmission) {
  WorkQueue queue;
  std::vector<int> order;  // only the worker writes, and we read after wait()
  for (int i = 0; i < 1000; ++i) queue.submit([&order, i] { order.push_back(i); });
  queue.wait();
  std::vector<int> expected(1000);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(order, expected);
}

TEST(WorkQueue, SubmitReturnsWhileTheTaskRuns) {
  WorkQueue queue;
  std::promise<void> release;
  bool finished = false;
  queue.submit([&] {
    release.get_future().wait();
    finished = true;
  });
  release.set_value();  // would never be reached if submit() ran the task itself
  queue.wait();
  EXPECT_TRUE(finished);
}

TEST(WorkQueue, WaitWithoutTasksReturns) {
  WorkQueue queue;
  queue.wait();
  SUCCEED();
}

TEST(WorkQueue, FirstExceptionIsThrownByWaitAndDropsTheTasksBehind) {
  WorkQueue queue;
  bool later_task_ran = false;
  std::promise<void> all_submitted;
  queue.submit([&] {
    all_submitted.get_future().wait();
    throw std::runtime_error("first");
  });
  queue.submit([] { throw std::runtime_error("second"); });
  queue.submit([&] { later_task_ran = true; });
  all_submitted.set_value();
  try {
    queue.wait();
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "first");
  }
  EXPECT_FALSE(later_task_ran);
}

TEST(WorkQueue, WorksAgainAfterAnException) {
  WorkQueue queue;
  queue.submit([] { throw std::runtime_error("once"); });
  EXPECT_THROW(queue.wait(), std::runtime_error);
  bool ran = false;
  queue.submit([&] { ran = true; });
  queue.wait();
  EXPECT_TRUE(ran);
}

TEST(WorkQueue, DestructionDropsTasksThatHaveNotBegun) {
  std::promise<void> started, release;
  bool second_ran = false;
  std::thread releaser;
  {
    WorkQueue queue;
    queue.submit([&] {
      started.set_value();
      release.get_future().wait();
    });
    queue.submit([&] { second_ran = true; });
    started.get_future().wait();
    releaser = std::thread([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));  // the destructor is waiting by then
      release.set_value();
    });
  }
  releaser.join();
  EXPECT_FALSE(second_ran);
}

}  // namespace
}  // namespace tentpole
