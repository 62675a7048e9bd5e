#include "host/fracture/crack_edge_state.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "kernels/element/quadrature.hpp"

namespace tentpole {
namespace {

/// Polynomials of degree num_points - 1 along the unit interval; damage stays within [0, 1].
double damage_at(double x, int num_points) {
  return 0.3 + 0.4 * std::pow(x, num_points - 1);
}
double gap_at(double x, int num_points) {
  return 2 * std::pow(x - 0.3, num_points - 1) - 1;
}

CrackEdgeState polynomial_edge(int num_points, double begin, double end) {
  CrackEdgeState edge{num_points, {}, {}};
  const Quadrature rule = gauss_jacobi(num_points, 0);
  for (int point = 0; point < num_points; ++point) {
    const double x = begin + (end - begin) * rule.points[point];
    edge.damage[point] = damage_at(x, num_points);
    edge.gap[point] = gap_at(x, num_points);
  }
  return edge;
}

void expect_near(const CrackEdgeState& edge, const CrackEdgeState& expected, double tolerance) {
  ASSERT_EQ(edge.num_points, expected.num_points);
  for (int point = 0; point < edge.num_points; ++point) {
    EXPECT_NEAR(edge.damage[point], expected.damage[point], tolerance);
    EXPECT_NEAR(edge.gap[point], expected.gap[point], tolerance);
  }
}

class RestrictToPart : public testing::TestWithParam<int> {};

TEST_P(RestrictToPart, ReproducesPolynomialsOnBothHalvesInEitherDirection) {
  const int num_points = GetParam();
  const CrackEdgeState edge = polynomial_edge(num_points, 0, 1);
  for (const double fraction : {0.1, 0.5, 0.85}) {
    expect_near(restrict_to_part(edge, 0, fraction), polynomial_edge(num_points, 0, fraction), 1e-14);
    expect_near(restrict_to_part(edge, fraction, 1), polynomial_edge(num_points, fraction, 1), 1e-14);
    expect_near(restrict_to_part(edge, fraction, 0), polynomial_edge(num_points, fraction, 0), 1e-14);
    expect_near(restrict_to_part(edge, 1, fraction), polynomial_edge(num_points, 1, fraction), 1e-14);
  }
}

TEST_P(RestrictToPart, PreservesMeanDamage) {
  const CrackEdgeState edge = polynomial_edge(GetParam(), 0, 1);
  const double halves =
      0.3 * mean_damage(restrict_to_part(edge, 0, 0.3)) + 0.7 * mean_damage(restrict_to_part(edge, 1, 0.3));
  EXPECT_NEAR(halves, mean_damage(edge), 1e-14);
}

TEST_P(RestrictToPart, RepeatedSplitsStayExact) {
  const int num_points = GetParam();
  CrackEdgeState part = polynomial_edge(num_points, 0, 1);
  for (int split = 0; split < 10; ++split) part = restrict_to_part(part, 0.5, 0);
  // ten halvings, each turned round, lie around a third of the edge
  double begin = 0, end = 1;
  for (int split = 0; split < 10; ++split) {
    const double middle = (begin + end) / 2;
    end = begin;
    begin = middle;
  }
  expect_near(part, polynomial_edge(num_points, begin, end), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Points, RestrictToPart, testing::Values(1, 2, 3, 5, 8));

TEST(RestrictToPartClamp, KeepsDamageBetweenZeroAndOne) {
  const CrackEdgeState edge{2, {1, 0}, {1, -1}};  // linear between points at 0.211 and 0.789
  const CrackEdgeState low = restrict_to_part(edge, 0, 0.2), high = restrict_to_part(edge, 0.8, 1);
  EXPECT_EQ(low.damage[0], 1);
  EXPECT_EQ(high.damage[1], 0);
  EXPECT_GT(low.gap[0], 1);  // a gap is not clamped
  EXPECT_LT(high.gap[1], -1);
}

TEST(CrackEdgeState, MeasuresWeighTheGaussPoints) {
  const CrackEdgeState edge{3, {0.999, 0.5, 1}, {}};  // weights 5/18, 4/9, 5/18
  EXPECT_NEAR(mean_damage(edge), (5 * 0.999 + 8 * 0.5 + 5) / 18, 1e-15);
  EXPECT_EQ(smallest_damage(edge), 0.5);
  EXPECT_EQ(largest_damage(edge), 1);
  EXPECT_NEAR(failed_fraction(edge), 5.0 / 9, 1e-15);
  EXPECT_FALSE(has_failed(edge));
}

TEST(CrackEdgeState, UniformEdgeHasTheSameDamageEverywhereAndNoGap) {
  const CrackEdgeState edge = uniform_crack_edge(4, 0.999);
  EXPECT_TRUE(has_failed(edge));
  EXPECT_NEAR(failed_fraction(edge), 1, 1e-15);
  EXPECT_NEAR(mean_damage(edge), 0.999, 1e-15);
  EXPECT_EQ(edge.gap[3], 0);
  EXPECT_FALSE(has_failed(uniform_crack_edge(1, 0.9989)));
}

TEST(CrackEdgeState, VertexOfABarHasOnePoint) {
  const CrackEdgeState vertex{1, {0.7}, {-1e-6}};
  EXPECT_EQ(mean_damage(vertex), 0.7);
  const CrackEdgeState same = restrict_to_part(vertex, 0, 1);
  EXPECT_EQ(same.damage[0], 0.7);
  EXPECT_EQ(same.gap[0], -1e-6);
}

FractureLaw law_between(double threshold, double strength) {
  return {.threshold = threshold,
          .strength = strength,
          .relaxation_time = 1,
          .delay_exponent = 10,
          .shear_factor = 1,
          .friction = 0};
}

TEST(CrackEdgeState, IsActiveWhereDamageGrowsOrIsAboutTo) {
  const FractureLaw law = law_between(3, 4);
  CrackEdgeState edge = uniform_crack_edge(3, 0);
  EXPECT_TRUE(is_active(edge, law)) << "no patch has been solved on a new edge";
  edge.effective_traction = 3.01 / traction_margin;
  EXPECT_TRUE(is_active(edge, law));
  edge.effective_traction = 2.99 / traction_margin;
  EXPECT_FALSE(is_active(edge, law));
  // f(3.5) = 1/2 is what this traction drives to; one point that lags is enough
  edge = uniform_crack_edge(3, 0.51);
  edge.effective_traction = 3.5 / traction_margin;
  EXPECT_FALSE(is_active(edge, law));
  edge.damage[1] = 0.49;
  EXPECT_TRUE(is_active(edge, law));
  edge = uniform_crack_edge(3, failed_damage);
  edge.effective_traction = 100;
  EXPECT_FALSE(is_active(edge, law)) << "it has failed";
}

TEST(CrackEdgeState, PartsKeepTheTractionOfTheEdge) {
  CrackEdgeState edge = uniform_crack_edge(2, 0.25);
  edge.effective_traction = 7;
  EXPECT_EQ(restrict_to_part(edge, 0, 0.5).effective_traction, 7);
}

}  // namespace
}  // namespace tentpole
