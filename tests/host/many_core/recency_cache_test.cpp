#include "host/many_core/recency_cache.hpp"

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

/// The definition: a block is found if it and all others since its last touch fit into the capacity.
bool is_found(const std::vector<int>& touched, int block, const std::vector<double>& size, double capacity) {
  std::set<int> since{block};
  for (auto it = touched.rbegin(); it != touched.rend() && *it != block; ++it) since.insert(*it);
  if (std::find(touched.begin(), touched.end(), block) == touched.end()) return false;
  double bytes = 0;
  for (const int each : since) bytes += size[each];
  return bytes <= capacity;
}

TEST(RecencyCache, FindsWhatFitsSinceItsLastTouch) {
  std::mt19937 random(7);
  for (const double capacity : {0.0, 5.0, 20.0, 60.0, 1000.0}) {
    RecencyCache cache(capacity);
    const std::vector<double> size{1, 2, 3, 5, 8, 13, 4, 4, 4, 7};
    std::vector<int> touched;
    for (int step = 0; step < 2000; ++step) {
      const int block = std::uniform_int_distribution<int>(0, 9)(random);
      const bool expected = is_found(touched, block, size, capacity);
      ASSERT_EQ(cache.touch(block, size[block]), expected) << "capacity " << capacity << ", step " << step;
      touched.push_back(block);
    }
  }
}

int found_in_last_round(int num_blocks, double capacity) {
  RecencyCache cache(capacity);
  int found = 0;
  for (int round = 0; round < 3; ++round) {
    found = 0;
    for (int block = 0; block < num_blocks; ++block) found += cache.touch(block, 1.0);
  }
  return found;
}

TEST(RecencyCache, StreamingAgainAndAgainFindsAllOrNothing) {
  EXPECT_EQ(found_in_last_round(66, 66), 66);
  EXPECT_EQ(found_in_last_round(67, 66), 0);
}

TEST(RecencyCache, BlockLargerThanTheCacheIsNeverFound) {
  RecencyCache cache(10);
  EXPECT_FALSE(cache.touch(1, 11));
  EXPECT_FALSE(cache.touch(1, 11));
  EXPECT_FALSE(cache.touch(2, 10));
  EXPECT_TRUE(cache.touch(2, 10));
}

}  // namespace
}  // namespace tentpole
