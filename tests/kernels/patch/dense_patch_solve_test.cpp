#include "kernels/patch/dense_patch_solve.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

TEST(SolveDensePatch, SolvesATwoByTwoSystemExactly) {
  const std::vector<double> matrix{4, 1, -2, 9}, rhs{6, 16};
  std::vector<double> solution(2);
  double residual = -1;
  DenseSolveScratch scratch;
  ASSERT_EQ(solve_dense_patch(matrix, rhs, solution, residual, scratch), Status::ok);
  EXPECT_NEAR(solution[0], 1, 1e-15);
  EXPECT_NEAR(solution[1], 2, 1e-15);
  EXPECT_LT(residual, 1e-15);
}

TEST(SolveDensePatch, RecoversAKnownSolutionOfABadlyScaledUnsymmetricMatrix) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const int size = 60;
  std::vector<double> matrix(size * size), exact(size), rhs(size, 0.0), solution(size);
  for (int a = 0; a < size; ++a) exact[a] = uniform(random) * std::pow(10, -(a % 8));
  for (int a = 0; a < size; ++a)
    for (int b = 0; b < size; ++b) {
      // Rows and columns scaled by 10^0 .. 10^7, as for unknowns of different units.
      matrix[a * size + b] = (uniform(random) / size + (a == b)) * std::pow(10, a % 8 + b % 8);
      rhs[a] += matrix[a * size + b] * exact[b];
    }
  double residual = -1;
  DenseSolveScratch scratch;
  ASSERT_EQ(solve_dense_patch(matrix, rhs, solution, residual, scratch), Status::ok);
  EXPECT_LT(residual, 1e-14);
  for (int a = 0; a < size; ++a) EXPECT_NEAR(solution[a] / exact[a], 1, 1e-10);
}

TEST(SolveDensePatch, ReportsSingularAndNotFiniteMatrices) {
  std::vector<double> solution(2);
  const std::vector<double> rhs{1, 2};
  double residual = 0;
  DenseSolveScratch scratch;
  EXPECT_EQ(solve_dense_patch(std::vector<double>{1, 1, 1, 1}, rhs, solution, residual, scratch),
            Status::singular_pivot);
  EXPECT_EQ(solve_dense_patch(std::vector<double>{0, 1, 1, 1}, rhs, solution, residual, scratch),
            Status::singular_pivot);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solve_dense_patch(std::vector<double>{1, nan, 0, 1}, rhs, solution, residual, scratch),
            Status::singular_pivot);
  EXPECT_FALSE(std::isfinite(residual) && residual < 1);
}

TEST(SolveDensePatch, ResidualOfZeroDataIsZero) {
  std::vector<double> solution(2, 7.0);
  double residual = -1;
  DenseSolveScratch scratch;
  ASSERT_EQ(solve_dense_patch(std::vector<double>{2, 1, 0, 3}, std::vector<double>{0, 0}, solution, residual, scratch),
            Status::ok);
  EXPECT_EQ(residual, 0);
  EXPECT_EQ(solution[0], 0);
}

}  // namespace
}  // namespace tentpole
