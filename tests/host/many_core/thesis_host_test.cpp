// What the thesis reports of its host, two Xeon X5680 [Marwah 2014, section 3.3.2], degrees 1 to 7.
#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "host/many_core/read_machine.hpp"
#include "host/many_core/row_sweep.hpp"

namespace tentpole {
namespace {

class ThesisHost : public testing::Test {
 protected:
  static constexpr int rows_of_degree[] = {1, 15, 45, 105, 210, 378, 630, 990};

  static void SetUpTestSuite() {
    const Machine machine = read_machine(TENTPOLE_MACHINES "/xeon_x5680_dual.toml");
    std::vector<int> counts(24);
    std::iota(counts.begin(), counts.end(), 1);
    for (int k = 1; k <= 7; ++k) sweeps_[k] = model_sweep(machine, rows_of_degree[k], counts);
  }
  static double speedup(int k, int p) { return sweeps_[k][p - 1].speedup; }
  static double best(int k) {
    double result = 0;
    for (const SweepPoint& point : sweeps_[k]) result = std::max(result, point.speedup);
    return result;
  }

  static inline std::vector<SweepPoint> sweeps_[8];
};

TEST_F(ThesisHost, DegreeSevenIsBestOnTwelveThreads) {
  EXPECT_NEAR(speedup(7, 12), 2.29, 0.05 * 2.29);
  for (int p = 1; p <= 24; ++p)
    if (p != 12) {
      EXPECT_LT(speedup(7, p), speedup(7, 12)) << p;
    }
}

TEST_F(ThesisHost, DegreesUpToThreeSlowDown) {
  for (int k = 1; k <= 3; ++k)
    for (int p = 2; p <= 24; ++p) EXPECT_LT(speedup(k, p), 1) << "degree " << k << ", " << p << " threads";
}

TEST_F(ThesisHost, DegreesSixAndSevenGainMost) {
  for (int k = 1; k <= 5; ++k) EXPECT_LT(best(k), std::min(best(6), best(7))) << k;
}

TEST_F(ThesisHost, MoreThreadsThanCoresLose) {
  for (int k = 1; k <= 7; ++k)
    for (int p = 13; p <= 24; ++p)
      EXPECT_LT(speedup(k, p), speedup(k, 12)) << "degree " << k << ", " << p << " threads";
}

}  // namespace
}  // namespace tentpole
