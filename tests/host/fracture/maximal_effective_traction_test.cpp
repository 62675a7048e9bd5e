#include "host/fracture/maximal_effective_traction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

double effective_traction(const PlaneStress& stress, double shear_factor, const PlaneNormal& n) {
  const double x = stress.xx * n[0] + stress.xy * n[1], y = stress.xy * n[0] + stress.yy * n[1];
  const double normal = x * n[0] + y * n[1], tangential = y * n[0] - x * n[1];
  return std::hypot(std::max(normal, 0.0), shear_factor * tangential);
}

/// Normals at 10^6 angles of the half circle.
const std::vector<PlaneNormal>& many_normals() {
  static const std::vector<PlaneNormal> normals = [] {
    std::vector<PlaneNormal> all;
    for (int i = 0; i < 1000000; ++i) {
      const double angle = std::numbers::pi * i / 1e6;
      all.push_back({std::cos(angle), std::sin(angle)});
    }
    return all;
  }();
  return normals;
}

double largest_of_many(const PlaneStress& stress, double shear_factor) {
  double largest = 0;
  for (const PlaneNormal& n : many_normals()) largest = std::max(largest, effective_traction(stress, shear_factor, n));
  return largest;
}

/// The closed form bears what it says in every direction that it names, and brute force finds nothing larger.
void expect_is_maximal(const PlaneStress& stress, double shear_factor) {
  const EffectiveTractionMaximum maximum = maximal_effective_traction(stress, shear_factor);
  const double scale = std::max({std::abs(stress.xx), std::abs(stress.yy), std::abs(stress.xy)});
  EXPECT_NEAR(maximum.effective_traction, largest_of_many(stress, shear_factor), 1e-10 * scale)
      << stress.xx << " " << stress.yy << " " << stress.xy << ", beta " << shear_factor;
  for (int i = 0; i < maximum.num_orientations; ++i)
    EXPECT_NEAR(effective_traction(stress, shear_factor, maximum.normal[i]), maximum.effective_traction, 1e-14 * scale);
}

TEST(MaximalEffectiveTraction, EqualsBruteForceForRandomStresses) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> component(-1, 1);
  for (const double shear_factor : {0.0, 0.5, 1.0, 1.2, 2.0, 5.0})
    for (int i = 0; i < 12; ++i)
      expect_is_maximal({component(generator), component(generator), component(generator)}, shear_factor);
}

TEST(MaximalEffectiveTraction, EqualsBruteForceForTensionAroundTheChangeOfBranch) {
  // m / (r (beta^2 - 1)) = 1 at beta = 1.5 for m = 1.25 r
  for (const double mean : {1.24, 1.25, 1.26}) expect_is_maximal({mean + 1, mean - 1, 0}, 1.5);
  for (const double mean : {-0.01, 0.0, 0.01})
    for (const double shear_factor : {0.99, 1.0, 1.01}) expect_is_maximal({mean + 1, mean - 1, 0}, shear_factor);
}

TEST(MaximalEffectiveTraction, UniaxialTensionIsBorneAcrossItsAxis) {
  const EffectiveTractionMaximum maximum = maximal_effective_traction({0, 3, 0}, 1);
  EXPECT_DOUBLE_EQ(maximum.effective_traction, 3);
  EXPECT_DOUBLE_EQ(maximum.normal_traction, 3);
  EXPECT_EQ(maximum.tangential_traction, 0);
  ASSERT_EQ(maximum.num_orientations, 1);
  EXPECT_NEAR(maximum.normal[0][0], 0, 1e-16);
  EXPECT_DOUBLE_EQ(std::abs(maximum.normal[0][1]), 1);
}

TEST(MaximalEffectiveTraction, LargeShearFactorGivesTwoMirroredOrientations) {
  // m = r = 1, beta = 2: c = 1/3, s_n = 4/3, s_t^2 = 8/9, s_eff^2 = 16/9 + 32/9
  const EffectiveTractionMaximum maximum = maximal_effective_traction({2, 0, 0}, 2);
  EXPECT_DOUBLE_EQ(maximum.effective_traction, std::sqrt(48.0) / 3);
  ASSERT_EQ(maximum.num_orientations, 2);
  EXPECT_DOUBLE_EQ(maximum.normal[0][0], std::sqrt(2.0 / 3));
  EXPECT_DOUBLE_EQ(maximum.normal[1][0], std::sqrt(2.0 / 3));
  EXPECT_DOUBLE_EQ(maximum.normal[0][1], std::sqrt(1.0 / 3));
  EXPECT_DOUBLE_EQ(maximum.normal[1][1], -std::sqrt(1.0 / 3));
}

TEST(MaximalEffectiveTraction, PressureBearsNothing) {
  expect_is_maximal({-2, -2, 0}, 1);
  EXPECT_EQ(maximal_effective_traction({-2, -2, 0}, 1).effective_traction, 0);
  EXPECT_EQ(maximal_effective_traction({-2, -1, 0.3}, 0).effective_traction, 0);
}

TEST(MaximalEffectiveTraction, UniaxialCompressionBearsItsShearOnCompressedSurfaces) {
  const EffectiveTractionMaximum maximum = maximal_effective_traction({-2, 0, 0}, 1);
  EXPECT_DOUBLE_EQ(maximum.effective_traction, 1);
  EXPECT_DOUBLE_EQ(maximum.normal_traction, -1);
  ASSERT_EQ(maximum.num_orientations, 2);
  EXPECT_NEAR(std::abs(maximum.normal[0][0]), std::sqrt(0.5), 1e-15);
  expect_is_maximal({-2, 0, 0}, 1);
}

TEST(MaximalEffectiveTraction, EquibiaxialTensionIsBorneInEveryOrientation) {
  const EffectiveTractionMaximum maximum = maximal_effective_traction({3, 3, 0}, 2);
  EXPECT_DOUBLE_EQ(maximum.effective_traction, 3);
  EXPECT_TRUE(maximum.every_orientation);
  expect_is_maximal({3, 3, 0}, 2);
  EXPECT_FALSE(maximal_effective_traction({3, 2.9, 0}, 2).every_orientation);
}

TEST(MaximalEffectiveTraction, TurnsWithTheStress) {
  const double angle = 0.3, c = std::cos(angle), s = std::sin(angle);  // principal stresses 4 and 1
  const PlaneStress turned{4 * c * c + s * s, 4 * s * s + c * c, 3 * c * s};
  const EffectiveTractionMaximum maximum = maximal_effective_traction(turned, 1);
  EXPECT_NEAR(maximum.normal[0][0], c, 1e-15);
  EXPECT_NEAR(maximum.normal[0][1], s, 1e-15);
}

TEST(MaximalEffectiveTraction, OneDimensionBearsTension) {
  EXPECT_EQ(maximal_effective_traction(2.5), 2.5);
  EXPECT_EQ(maximal_effective_traction(-2.5), 0);
}

}  // namespace
}  // namespace tentpole
