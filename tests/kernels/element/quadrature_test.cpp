#include "kernels/element/quadrature.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

/// int over the unit simplex of prod x_j^e_j = prod e_j! / (dimension + sum e_j)!
double monomial_integral(const std::vector<int>& exponents) {
  double result = 1;
  int total = static_cast<int>(exponents.size());
  for (const int e : exponents) {
    result *= std::tgamma(e + 1.0);
    total += e;
  }
  return result / std::tgamma(total + 1.0);
}

std::vector<std::vector<int>> all_exponents(int dimension, int degree) {
  if (dimension == 0) return {{}};
  std::vector<std::vector<int>> result;
  for (int first = 0; first <= degree; ++first)
    for (std::vector<int> rest : all_exponents(dimension - 1, degree - first)) {
      rest.push_back(first);
      result.push_back(rest);
    }
  return result;
}

TEST(SimplexQuadrature, IntegratesEveryMonomialUpToItsDegree) {
  for (int dimension = 0; dimension <= 4; ++dimension)
    for (int degree = 0; degree <= (dimension == 4 ? 10 : 16); ++degree) {
      const Quadrature rule = simplex_quadrature(dimension, degree);
      for (const auto& exponents : all_exponents(dimension, degree)) {
        double sum = 0;
        for (int q = 0; q < rule.num_points(); ++q) {
          double term = rule.weights[q];
          for (int j = 0; j < dimension; ++j) term *= std::pow(rule.points[q * dimension + j], exponents[j]);
          sum += term;
        }
        const double exact = monomial_integral(exponents);
        ASSERT_NEAR(sum, exact, 2e-14 * exact) << "dimension " << dimension << ", degree " << degree;
      }
    }
}

TEST(SimplexQuadrature, PointsLieInsideAndWeightsArePositive) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    const Quadrature rule = simplex_quadrature(dimension, 9);
    ASSERT_EQ(rule.num_points(), static_cast<int>(std::pow(5, dimension)));
    for (int q = 0; q < rule.num_points(); ++q) {
      EXPECT_GT(rule.weights[q], 0);
      double sum = 0;
      for (int j = 0; j < dimension; ++j) {
        EXPECT_GT(rule.points[q * dimension + j], 0);
        sum += rule.points[q * dimension + j];
      }
      EXPECT_LT(sum, 1);
    }
  }
}

TEST(GaussJacobi, TwoPointLegendreRuleHasTheKnownPoints) {
  const Quadrature rule = gauss_jacobi(2, 0);
  EXPECT_NEAR(rule.points[0], 0.5 - 0.5 / std::sqrt(3.0), 1e-16);
  EXPECT_NEAR(rule.points[1], 0.5 + 0.5 / std::sqrt(3.0), 2e-16);
  EXPECT_NEAR(rule.weights[0], 0.5, 1e-16);
}

TEST(GaussJacobi, IntegratesPowersAgainstTheWeight) {
  for (int alpha = 0; alpha <= 5; ++alpha)
    for (int n = 1; n <= 12; ++n) {
      const Quadrature rule = gauss_jacobi(n, alpha);
      for (int power = 0; power < 2 * n; ++power) {
        double sum = 0;
        for (int q = 0; q < n; ++q) sum += rule.weights[q] * std::pow(rule.points[q], power);
        // Beta function B(power + 1, alpha + 1)
        const double exact = std::exp(std::lgamma(power + 1) + std::lgamma(alpha + 1) - std::lgamma(power + alpha + 2));
        ASSERT_NEAR(sum, exact, 1e-13 * exact) << n << " points, alpha " << alpha << ", power " << power;
      }
    }
}

TEST(SimplexQuadrature, RefusesDimensionsItDoesNotHave) {
  EXPECT_THROW(simplex_quadrature(5, 2), std::invalid_argument);
  EXPECT_THROW(simplex_quadrature(2, -1), std::invalid_argument);
  EXPECT_THROW(gauss_jacobi(0, 0), std::invalid_argument);
}

}  // namespace
}  // namespace tentpole
