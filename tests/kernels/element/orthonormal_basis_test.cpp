#include "kernels/element/orthonormal_basis.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "common/simplex.hpp"
#include "kernels/element/quadrature.hpp"

namespace tentpole {
namespace {

/// A polynomial given by its value, gradient and Hessian: (1 + c . x)^power, which has all monomials of degree <=
/// power.
struct PowerOfLinear {
  std::vector<double> slope;
  int power;

  double derivative(const double* x, int order) const {
    double base = 1, factor = 1;
    for (std::size_t l = 0; l < slope.size(); ++l) base += slope[l] * x[l];
    for (int i = 0; i < order; ++i) factor *= power - i;
    return factor == 0 ? 0 : factor * std::pow(base, power - order);
  }
};

PowerOfLinear random_polynomial(int dimension, int power, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  PowerOfLinear polynomial{{}, power};
  for (int l = 0; l < dimension; ++l) polynomial.slope.push_back(uniform(random));
  return polynomial;
}

/// Coefficients of the L2 projection onto the basis.
std::vector<double> project(const OrthonormalBasis& basis, const PowerOfLinear& polynomial) {
  const int d = basis.dimension();
  const Quadrature rule = simplex_quadrature(d, 2 * basis.degree());
  std::vector<double> coefficients(basis.size(), 0.0), value(basis.size());
  for (int q = 0; q < rule.num_points(); ++q) {
    const double* x = &rule.points[q * d];
    basis.values({x, static_cast<std::size_t>(d)}, value);
    for (int a = 0; a < basis.size(); ++a) coefficients[a] += rule.weights[q] * value[a] * polynomial.derivative(x, 0);
  }
  return coefficients;
}

TEST(OrthonormalBasis, IsOrthonormal) {
  for (int dimension = 1; dimension <= 4; ++dimension)
    for (int degree = 0; degree <= (dimension == 4 ? 5 : max_degree); ++degree) {
      const OrthonormalBasis basis(dimension, degree);
      const Quadrature rule = simplex_quadrature(dimension, 2 * degree);
      const int n = basis.size();
      std::vector<double> gram(n * n, 0.0), value(n);
      for (int q = 0; q < rule.num_points(); ++q) {
        basis.values({&rule.points[q * dimension], static_cast<std::size_t>(dimension)}, value);
        for (int a = 0; a < n; ++a)
          for (int b = 0; b < n; ++b) gram[a * n + b] += rule.weights[q] * value[a] * value[b];
      }
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) ASSERT_NEAR(gram[a * n + b], a == b ? 1 : 0, 1e-13) << dimension << " " << degree;
    }
}

TEST(OrthonormalBasis, OrthonormalAtTheHighestDegreeInFourDimensions) {
  const OrthonormalBasis basis(4, max_degree);
  const Quadrature rule = simplex_quadrature(4, 2 * max_degree);
  const int n = basis.size();
  ASSERT_EQ(n, 330);
  std::vector<double> gram(n * n, 0.0), value(n);
  for (int q = 0; q < rule.num_points(); ++q) {
    basis.values({&rule.points[q * 4], 4}, value);
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) gram[a * n + b] += rule.weights[q] * value[a] * value[b];
  }
  double worst = 0;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) worst = std::max(worst, std::abs(gram[a * n + b] - (a == b ? 1 : 0)));
  EXPECT_LT(worst, 1e-13);
}

TEST(OrthonormalBasis, FirstFunctionsSpanEveryLowerDegree) {
  std::mt19937 random(1);
  for (int dimension = 1; dimension <= 4; ++dimension) {
    const OrthonormalBasis basis(dimension, 5);
    for (int lower = 0; lower <= 5; ++lower) {
      const auto coefficients = project(basis, random_polynomial(dimension, lower, random));
      for (int a = num_polynomials(dimension, lower); a < basis.size(); ++a) EXPECT_NEAR(coefficients[a], 0, 1e-13);
      EXPECT_GT(std::abs(coefficients[0]), 0);
    }
  }
}

TEST(OrthonormalBasis, ReproducesPolynomialsWithGradientsAndHessians) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-0.3, 1.0);  // outside the simplex too
  for (int dimension = 1; dimension <= 4; ++dimension)
    for (int degree = 0; degree <= (dimension == 4 ? 5 : max_degree); ++degree) {
      const OrthonormalBasis basis(dimension, degree);
      const PowerOfLinear exact = random_polynomial(dimension, degree, random);
      const auto coefficients = project(basis, exact);
      const int n = basis.size();
      std::vector<double> x(dimension), value(n), gradient(n * dimension), hessian(n * dimension * dimension);
      for (double& coordinate : x) coordinate = uniform(random);
      basis.values(x, value);
      basis.gradients(x, gradient);
      basis.hessians(x, hessian);
      // The projection is accurate to rounding of its largest coefficient; outside the simplex derivatives amplify
      // that.
      double sum = 0, largest_coefficient = 0, largest_derivative = 1;
      for (int a = 0; a < n; ++a) {
        sum += coefficients[a] * value[a];
        largest_coefficient = std::max(largest_coefficient, std::abs(coefficients[a]));
      }
      for (const double h : hessian) largest_derivative = std::max(largest_derivative, std::abs(h));
      const double scale = largest_coefficient * largest_derivative;
      EXPECT_NEAR(sum, exact.derivative(x.data(), 0), 1e-12 * scale);
      for (int l = 0; l < dimension; ++l) {
        double slope = 0;
        for (int a = 0; a < n; ++a) slope += coefficients[a] * gradient[a * dimension + l];
        EXPECT_NEAR(slope, exact.slope[l] * exact.derivative(x.data(), 1), 1e-12 * scale);
        for (int m = 0; m < dimension; ++m) {
          double curvature = 0;
          for (int a = 0; a < n; ++a) curvature += coefficients[a] * hessian[(a * dimension + l) * dimension + m];
          EXPECT_NEAR(curvature, exact.slope[l] * exact.slope[m] * exact.derivative(x.data(), 2), 1e-12 * scale);
        }
      }
    }
}

TEST(OrthonormalBasis, IsFiniteAtEveryCornerOfTheSimplex) {
  const OrthonormalBasis basis(4, max_degree);
  std::vector<double> hessian(basis.size() * 16);
  for (int corner = 0; corner <= 4; ++corner) {
    std::vector<double> x(4, 0.0);
    if (corner > 0) x[corner - 1] = 1;
    basis.hessians(x, hessian);
    for (const double h : hessian) ASSERT_TRUE(std::isfinite(h));
  }
}

TEST(OrthonormalBasis, IsTheConstantOneInDimensionZero) {
  const OrthonormalBasis basis(0, 3);
  double value = 0;
  basis.values({}, {&value, 1});
  EXPECT_EQ(basis.size(), 1);
  EXPECT_EQ(value, 1);
}

TEST(OrthonormalBasis, RefusesFiveDimensions) {
  EXPECT_THROW(OrthonormalBasis(5, 1), std::invalid_argument);
  EXPECT_THROW(OrthonormalBasis(2, -1), std::invalid_argument);
}

}  // namespace
}  // namespace tentpole
