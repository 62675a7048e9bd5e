#include "device/free_memory.hpp"

#include <fstream>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

namespace tentpole {
namespace {

TEST(FreeHostMemory, IsNoMoreThanALimitOnAddressesLeaves) {
  const std::optional<std::int64_t> without = free_host_memory();
  if (!without) GTEST_SKIP() << "this system does not say";
  EXPECT_GT(*without, 0);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  std::int64_t pages = 0;
  ASSERT_TRUE(std::ifstream("/proc/self/statm") >> pages);
  constexpr std::int64_t rest = 64 << 20;
  rlimit limited = before;
  limited.rlim_cur = pages * sysconf(_SC_PAGESIZE) + rest;
  ASSERT_EQ(setrlimit(RLIMIT_AS, &limited), 0);
  const std::optional<std::int64_t> with = free_host_memory();
  setrlimit(RLIMIT_AS, &before);
  ASSERT_TRUE(with);
  EXPECT_LE(*with, rest);
  EXPECT_GT(*with, rest / 2) << "little was taken in between";
}

}  // namespace
}  // namespace tentpole
