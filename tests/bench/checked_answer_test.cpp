#include "bench/checked_answer.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

TEST(CheckedAnswer, DifferenceIsRelativeToTheLargestEntry) {
  const std::vector<double> expected{1.0, -4.0, 2.0};
  EXPECT_EQ(relative_difference(std::vector<double>{1.0, -4.0, 2.0}, expected), 0);
  EXPECT_NEAR(relative_difference(std::vector<double>{1.5, -4.0, 2.0}, expected), 0.125, 1e-15);
}

TEST(CheckedAnswer, DifferenceIsInfiniteWhereNothingCanBeCompared) {
  const std::vector<double> expected{1.0, 2.0};
  EXPECT_TRUE(std::isinf(relative_difference(std::vector<double>{1.0}, expected)));
  EXPECT_TRUE(std::isinf(relative_difference(std::vector<double>{1.0, std::nan("")}, expected)));
}

TEST(CheckedAnswer, RightAnswerPasses) {
  EXPECT_EQ(require_answer("bench_assembly: sequential, d = 4, k = 7", 1e-13, 1e-12), 1e-13);
}

TEST(CheckedAnswerDeathTest, WrongAnswerEndsTheDriverWithExitCodeOneAndSaysWhich) {
  EXPECT_EXIT(require_answer("bench_assembly: sequential, d = 4, k = 7", 1e-3, 1e-12), testing::ExitedWithCode(1),
              "bench_assembly: sequential, d = 4, k = 7: wrong answer, error 1.0e-03");
  EXPECT_EXIT(require_answer("bench_lu: lapack", std::numeric_limits<double>::quiet_NaN(), 1e-12),
              testing::ExitedWithCode(1), "bench_lu: lapack: wrong answer");
}

}  // namespace
}  // namespace tentpole
