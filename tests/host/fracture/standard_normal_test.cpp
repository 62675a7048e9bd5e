#include "host/fracture/standard_normal.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

/// Quantiles of the doubles nearest to these probabilities, to 20 digits, computed with 40 digits.
struct Quantile {
  double probability, x;
};
constexpr Quantile quantiles[] = {
    {1e-300, -37.047096299361199237},    {1e-100, -21.273453560965324294}, {1e-20, -9.2623400897984075796},
    {1e-9, -5.9978070150076868614},      {2e-4, -3.5400837992061451032},   {0.02425, -1.9729610513118848376},
    {0.1, -1.2815515655446004353},       {0.25, -0.6744897501960817432},   {0.4, -0.25334710313579974132},
    {0.4999, -2.5066283008800749239e-4}, {0.6, 0.25334710313579974132},    {0.975, 1.9599639845400538556},
    {0.9999, 3.7190164854557083867}};

TEST(NormalQuantile, IsAccurateFromDeepTailToMiddle) {
  for (const auto& [probability, x] : quantiles)
    EXPECT_NEAR(normal_quantile(probability), x, 1e-14 * std::abs(x) + 1e-16) << probability;
  EXPECT_NEAR(normal_quantile(0.5), 0, 1e-17);
}

TEST(NormalQuantile, InvertsTheProbability) {
  for (double x = -37; x <= 0; x += 0.37)
    EXPECT_NEAR(normal_quantile(normal_probability(x)), x, 1e-13 * (1 + std::abs(x)));
}

TEST(NormalQuantile, IsOddAroundOneHalf) {
  for (const double probability : {0.25, 0.125, 1.0 / 1024})
    EXPECT_EQ(normal_quantile(1 - probability), -normal_quantile(probability));
}

TEST(NormalQuantile, EndsAreInfinite) {
  EXPECT_EQ(normal_quantile(0), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(normal_quantile(1), std::numeric_limits<double>::infinity());
}

TEST(NormalProbability, KeepsItsDigitsInTheLowerTail) {
  EXPECT_NEAR(normal_probability(1), 0.84134474606854294859, 1e-16);
  EXPECT_NEAR(normal_probability(-3.5) / 0.00023262907903552503635, 1, 1e-14);
  EXPECT_NEAR(normal_probability(-30) / 4.9067139271481870595e-198, 1, 1e-12);
}

}  // namespace
}  // namespace tentpole
