#include "device/thread_choice.hpp"

#include <climits>

#include <gtest/gtest.h>

#include "device/core_quota.hpp"
#include "tests/temporary_folder.hpp"

namespace tentpole {
namespace {

TEST(CoreQuota, OfVersion2IsTheLeastOfTheGroupAndThoseAbove) {
  const TemporaryFolder root;
  const auto membership = root.write("membership", "0::/slurm/job_7/step_0\n");
  EXPECT_FALSE(core_quota(root.path(), membership)) << "no files at all";
  root.write("slurm/job_7/step_0/cpu.max", "max 100000\n");
  EXPECT_FALSE(core_quota(root.path(), membership));
  root.write("slurm/job_7/cpu.max", "50000 100000\n");
  EXPECT_EQ(core_quota(root.path(), membership), 0.5);
  root.write("slurm/job_7/step_0/cpu.max", "300000 200000\n");
  EXPECT_EQ(core_quota(root.path(), membership), 0.5);
  root.write("slurm/job_7/cpu.max", "400000 100000\n");
  EXPECT_EQ(core_quota(root.path(), membership), 1.5);
  root.write("slurm/job_8/cpu.max", "1000 100000\n");
  EXPECT_EQ(core_quota(root.path(), membership), 1.5) << "the group of others";
}

TEST(CoreQuota, OfAContainerIsThatOfItsRoot) {
  const TemporaryFolder root;
  root.write("cpu.max", "250000 100000\n");
  for (const char* path : {"/", "/../../other", "/docker/5af1"})
    EXPECT_EQ(core_quota(root.path(), root.write("membership", std::string("0::") + path + "\n")), 2.5) << path;
}

TEST(CoreQuota, OfVersion1IsReadFromTheGroupOfTheCores) {
  const TemporaryFolder root;
  const auto membership = root.write("membership", "9:memory:/job\n4:cpu,cpuacct:/job\n1:cpuset:/\n0::/\n");
  root.write("cpu,cpuacct/job/cpu.cfs_quota_us", "-1\n");
  root.write("cpu,cpuacct/job/cpu.cfs_period_us", "100000\n");
  root.write("memory/job/cpu.cfs_quota_us", "1000\n");
  root.write("memory/job/cpu.cfs_period_us", "100000\n");
  EXPECT_FALSE(core_quota(root.path(), membership));
  root.write("cpu,cpuacct/job/cpu.cfs_quota_us", "150000\n");
  EXPECT_EQ(core_quota(root.path(), membership), 1.5);
}

TEST(CoreQuota, OfNonsenseIsNone) {
  const TemporaryFolder root;
  EXPECT_FALSE(core_quota(root.path(), root.path() / "missing"));
  const auto membership = root.write("membership", "noise\n\n0:\n0::/\n");
  for (const char* text : {"", "x y", "0 100000", "100000 0", "-5 100000"}) {
    root.write("cpu.max", text);
    EXPECT_FALSE(core_quota(root.path(), membership)) << text;
  }
}

TEST(ThreadChoice, IsTheUsualNumberWithoutLimits) {
  const ThreadSupply supply{.usual = 8, .limit = INT_MAX};
  EXPECT_EQ(choose_threads(supply, 0).threads, 8);
  EXPECT_EQ(choose_threads(supply, 12).threads, 12);
  EXPECT_EQ(choose_threads(supply, 12).reason, "");
}

TEST(ThreadChoice, KeepsAQuotaBusyAndNoMore) {
  const auto choose = [](double quota, int requested, bool is_chosen = false) {
    return choose_threads({.usual = 4, .is_chosen = is_chosen, .limit = INT_MAX, .quota = quota}, requested);
  };
  EXPECT_EQ(choose(0.5, 0).threads, 1);
  EXPECT_EQ(choose(0.5, 0).reason, "its control group grants it 0.5 cores");
  EXPECT_EQ(choose(1, 0).threads, 1);
  EXPECT_EQ(choose(1, 0).reason, "its control group grants it 1 core");
  EXPECT_EQ(choose(1.5, 0).threads, 2);
  EXPECT_EQ(choose(4, 0).threads, 4);
  EXPECT_EQ(choose(4, 0).reason, "");
  EXPECT_EQ(choose(64, 0).threads, 4) << "the affinity mask says 4";
  EXPECT_EQ(choose(0.5, 2).threads, 2) << "as asked for, and said";
  EXPECT_EQ(choose(0.5, 2).reason, "its control group grants it 0.5 cores");
  EXPECT_EQ(choose(0.5, 0, true).threads, 4) << "OMP_NUM_THREADS asks for it";
  EXPECT_EQ(choose(8, 2).reason, "");
}

TEST(ThreadChoice, NeverExceedsTheLimit) {
  ThreadSupply supply{.usual = 8, .limit = 3};
  for (const int requested : {0, 4, 100}) {
    EXPECT_EQ(choose_threads(supply, requested).threads, 3);
    EXPECT_EQ(choose_threads(supply, requested).reason, "OMP_THREAD_LIMIT");
  }
  EXPECT_EQ(choose_threads(supply, 2).threads, 2);
  EXPECT_EQ(choose_threads(supply, 2).reason, "");
  supply.quota = 0.5;
  EXPECT_EQ(choose_threads(supply, 9).reason, "OMP_THREAD_LIMIT; its control group grants it 0.5 cores");
  EXPECT_EQ(choose_threads(supply, 0).threads, 1);
}

}  // namespace
}  // namespace tentpole
