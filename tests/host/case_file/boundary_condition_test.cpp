#include "host/case_file/boundary_condition.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

using Vector = std::array<double, 3>;
const SourceLocation place{"case.toml", 7, 0, "boundary.left", ""};

Expression expression(const char* text) {
  return {text, {}, place};
}

void expect_near(const Vector& actual, const Vector& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], 1e-14) << "component " << i;
}

TEST(Ramp, CubicRisesFromZeroToOneWithFlatEnds) {
  const Ramp ramp{2e-9, RampOrder::cubic};
  EXPECT_EQ(ramp.factor(-1e-9), 0);
  EXPECT_EQ(ramp.factor(0), 0);
  EXPECT_DOUBLE_EQ(ramp.factor(0.5e-9), 0.15625);  // r = 1/4: 1/16 * 5/2
  EXPECT_DOUBLE_EQ(ramp.factor(1e-9), 0.5);
  EXPECT_DOUBLE_EQ(ramp.factor(2e-9), 1);
  EXPECT_DOUBLE_EQ(ramp.factor(1), 1);
}

TEST(Ramp, QuinticHasTheClosedFormAndFlatterEnds) {
  const Ramp ramp{4, RampOrder::quintic};
  EXPECT_DOUBLE_EQ(ramp.factor(1), 6 / 1024.0 - 15 / 256.0 + 10 / 64.0);
  EXPECT_DOUBLE_EQ(ramp.factor(2), 0.5);
  EXPECT_DOUBLE_EQ(ramp.factor(4), 1);
  EXPECT_LT(ramp.factor(0.01), Ramp({4, RampOrder::cubic}).factor(0.01));
}

TEST(Ramp, WithoutRiseTimeTheLoadIsFullAtOnce) {
  EXPECT_EQ(Ramp().factor(0), 1);
}

TEST(BoundaryCondition, NormalIsOutwardPositiveAndTangentTurnsLeft) {
  BoundaryCondition condition = BoundaryCondition::by_components(
      2, BoundaryKind::velocity, expression("2"), BoundaryKind::traction, VectorExpression({expression("3")}), {});
  expect_near(condition.value({}, 0, {1, 0, 0}), {2, 3, 0});
  expect_near(condition.value({}, 0, {-1, 0, 0}), {-2, -3, 0});
  expect_near(condition.value({}, 0, {0, 1, 0}), {-3, 2, 0});
  expect_near(condition.value({}, 0, {0.6, 0.8, 0}), {2 * 0.6 - 3 * 0.8, 2 * 0.8 + 3 * 0.6, 0});
  EXPECT_EQ(condition.normal_kind(), BoundaryKind::velocity);
  EXPECT_EQ(condition.tangential_kind(), BoundaryKind::traction);
}

TEST(BoundaryCondition, InThreeDimensionsOnlyTheTangentialPartOfTheVectorCounts) {
  BoundaryCondition condition =
      BoundaryCondition::by_components(3, BoundaryKind::traction, expression("5"), BoundaryKind::velocity,
                                       VectorExpression({expression("1"), expression("2"), expression("3")}), {});
  expect_near(condition.value({}, 0, {0, 0, 1}), {1, 2, 5});
  const double s = std::sqrt(0.5);
  const double along = s * (1 + 2);
  expect_near(condition.value({}, 0, {s, s, 0}), {1 + (5 - along) * s, 2 + (5 - along) * s, 3});
}

TEST(BoundaryCondition, OneDimensionHasTheNormalOnly) {
  BoundaryCondition condition =
      BoundaryCondition::by_components(1, BoundaryKind::traction, expression("7*t"), BoundaryKind::traction, {}, {});
  expect_near(condition.value({}, 2, {-1, 0, 0}), {-14, 0, 0});
}

TEST(BoundaryCondition, GlobalVectorIsIndependentOfTheNormalAndIsRamped) {
  BoundaryCondition condition = BoundaryCondition::by_vector(
      BoundaryKind::traction, VectorExpression({expression("x"), expression("y*t")}), {4, RampOrder::cubic});
  expect_near(condition.value({2, 3, 0}, 2, {0, 1, 0}), {1, 3, 0});
  expect_near(condition.value({2, 3, 0}, 8, {1, 0, 0}), {2, 24, 0});
  EXPECT_EQ(condition.normal_kind(), BoundaryKind::traction);
  EXPECT_EQ(condition.tangential_kind(), BoundaryKind::traction);
}

TEST(BoundaryCondition, AbsorbingIsZeroAndPeriodicHasAPartner) {
  BoundaryCondition absorbing = BoundaryCondition::absorbing();
  EXPECT_EQ(absorbing.normal_kind(), BoundaryKind::absorbing);
  EXPECT_EQ(absorbing.tangential_kind(), BoundaryKind::absorbing);
  EXPECT_TRUE(absorbing.is_zero());
  EXPECT_TRUE(absorbing.is_absorbing());
  EXPECT_FALSE(absorbing.has_far_field());
  EXPECT_FALSE(absorbing.is_periodic());
  expect_near(absorbing.value({1, 2, 3}, 4, {1, 0, 0}), {0, 0, 0});
  EXPECT_EQ(BoundaryCondition::periodic("right").periodic_partner(), "right");
}

TEST(BoundaryCondition, FarFieldHasVelocityAndTraction) {
  BoundaryCondition condition = BoundaryCondition::absorbing(VectorExpression({expression("x"), expression("0")}),
                                                             VectorExpression({expression("0"), expression("3*t")}));
  EXPECT_TRUE(condition.is_absorbing());
  EXPECT_TRUE(condition.has_far_field());
  EXPECT_FALSE(condition.is_zero());
  expect_near(condition.far_field_velocity({2, 0, 0}, 5), {2, 0, 0});
  expect_near(condition.value({2, 0, 0}, 5, {1, 0, 0}), {0, 15, 0});
}

TEST(BoundaryCondition, IsZeroOnlyIfNothingIsPrescribed) {
  const auto make = [](const char* normal, const char* tangential) {
    return BoundaryCondition::by_components(2, BoundaryKind::velocity, expression(normal), BoundaryKind::velocity,
                                            VectorExpression({expression(tangential)}), {});
  };
  EXPECT_TRUE(make("0", "0").is_zero());
  EXPECT_FALSE(make("1", "0").is_zero());
  EXPECT_FALSE(make("0", "x").is_zero());
}

}  // namespace
}  // namespace tentpole
