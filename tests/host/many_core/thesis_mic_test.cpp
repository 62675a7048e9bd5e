// What the thesis reports of its Xeon Phi [Marwah 2014, section 3.3.4], n = 990.
#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "host/many_core/read_machine.hpp"
#include "host/many_core/row_sweep.hpp"

namespace tentpole {
namespace {

class ThesisMic : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::vector<int> counts(240);
    std::iota(counts.begin(), counts.end(), 1);
    for (const SweepPoint& point : model_sweep(read_machine(TENTPOLE_MACHINES "/xeon_phi_knc.toml"), 990, counts))
      points_[point.threads] = point;
  }
  static double speedup(int p) { return points_.at(p).speedup; }
  static double efficiency(int p) { return points_.at(p).efficiency; }

  static inline std::map<int, SweepPoint> points_;
};

TEST_F(ThesisMic, SpeedupOnSixtyThreads) {
  EXPECT_NEAR(speedup(60), 33.17, 0.05 * 33.17);
}

TEST_F(ThesisMic, SpeedupIsLargestOnSixtyThreads) {
  for (const auto& [p, point] : points_)
    if (p != 60) {
      EXPECT_LT(point.speedup, speedup(60)) << p;
    }
}

TEST_F(ThesisMic, SpeedupRisesToSixty) {
  // Over counts with no more rows on the busiest thread than on that of the next one, it may dip by imbalance.
  for (int p = 2; p <= 60; ++p) EXPECT_GT(speedup(p), 0.99 * speedup(p - 1)) << p;
  for (int p = 10; p <= 60; p += 5) EXPECT_GT(speedup(p), speedup(p - 5)) << p;
}

TEST_F(ThesisMic, EfficiencyFallsToFourteenThreads) {
  for (int p = 2; p <= 14; ++p) EXPECT_LT(efficiency(p), efficiency(p - 1)) << p;
}

TEST_F(ThesisMic, EfficiencyRisesWhereTheMatrixFitsTheCaches) {
  EXPECT_GT(efficiency(15), efficiency(14));
  EXPECT_GT(efficiency(22), efficiency(15));
}

TEST_F(ThesisMic, EfficiencyFallsAfterTwentyThree) {
  EXPECT_LT(efficiency(24), efficiency(23));
}

TEST_F(ThesisMic, BestBalancedEfficiencyIsOnThirtyThreads) {
  for (const auto& [p, point] : points_)
    if (p >= 15 && p != 30 && (point.imbalance == 0 || point.imbalance > 0.9)) {
      EXPECT_LT(point.efficiency, efficiency(30)) << p;
    }
}

}  // namespace
}  // namespace tentpole
