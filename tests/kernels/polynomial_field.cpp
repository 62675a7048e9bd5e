#include "tests/kernels/polynomial_field.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tentpole {
namespace {

std::array<int, max_dimension + 1> unit(int j) {
  std::array<int, max_dimension + 1> orders{};
  orders[j] = 1;
  return orders;
}

std::array<int, max_dimension + 1> pair(int j, int k) {
  std::array<int, max_dimension + 1> orders = unit(j);
  ++orders[k];
  return orders;
}

}  // namespace

PolynomialField::PolynomialField(int dimension, int degree) : dimension_(dimension) {
  std::array<int, max_dimension + 1> exponents{};
  const auto append = [&](auto&& self, int j, int remaining) -> void {
    if (j > dimension) {
      exponents_.push_back(exponents);
      return;
    }
    for (exponents[j] = 0; exponents[j] <= remaining; ++exponents[j]) self(self, j + 1, remaining - exponents[j]);
    exponents[j] = 0;
  };
  append(append, 0, degree);
  coefficients_.assign(dimension, std::vector<double>(exponents_.size(), 0.0));
}

PolynomialField PolynomialField::random(int dimension, int degree, std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  PolynomialField field(dimension, degree);
  for (auto& component : field.coefficients_)
    for (double& coefficient : component) coefficient = uniform(generator);
  return field;
}

PolynomialField PolynomialField::random_translation(int dimension, int degree, std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  PolynomialField field(dimension, degree);
  for (int i = 0; i < dimension; ++i)
    for (int power = 0; power <= degree; ++power) {
      std::array<int, max_dimension + 1> exponents{};
      exponents[dimension] = power;
      field.coefficient(i, exponents) = uniform(generator);
    }
  return field;
}

double& PolynomialField::coefficient(int i, const std::array<int, max_dimension + 1>& exponents) {
  const auto found = std::find(exponents_.begin(), exponents_.end(), exponents);
  if (found == exponents_.end()) throw std::out_of_range("PolynomialField: monomial above the degree of the field");
  return coefficients_[i][found - exponents_.begin()];
}

double PolynomialField::derivative(int i, const SpacetimePoint& point,
                                   const std::array<int, max_dimension + 1>& orders) const {
  double sum = 0;
  for (std::size_t m = 0; m < exponents_.size(); ++m) {
    double term = coefficients_[i][m];
    for (int j = 0; j <= dimension_; ++j) {
      const int power = exponents_[m][j];
      for (int k = 0; k < orders[j]; ++k) term *= power - k;
      if (power > orders[j]) term *= std::pow(point[j], power - orders[j]);
    }
    sum += term;
  }
  return sum;
}

double PolynomialField::displacement(int i, const SpacetimePoint& point) const {
  return derivative(i, point, {});
}

double PolynomialField::velocity(int i, const SpacetimePoint& point) const {
  return derivative(i, point, unit(dimension_));
}

double PolynomialField::strain(int i, int j, const SpacetimePoint& point) const {
  return (derivative(i, point, unit(j)) + derivative(j, point, unit(i))) / 2;
}

double PolynomialField::stress(int i, int j, const Material& material, const SpacetimePoint& point) const {
  double trace = 0;
  for (int l = 0; l < dimension_; ++l) trace += strain(l, l, point);
  return 2 * material.mu * strain(i, j, point) + (i == j ? material.lambda * trace : 0);
}

double PolynomialField::body_force(int i, const Material& material, const SpacetimePoint& point) const {
  double force = material.density * derivative(i, point, pair(dimension_, dimension_));
  for (int j = 0; j < dimension_; ++j)
    force -= (material.lambda + material.mu) * derivative(j, point, pair(i, j)) +
             material.mu * derivative(i, point, pair(j, j));
  return force;
}

}  // namespace tentpole
