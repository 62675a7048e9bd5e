#pragma once

#include <array>
#include <random>
#include <vector>

#include "common/material.hpp"
#include "common/simplex.hpp"

namespace tentpole {

/// Point of spacetime: x.. then t in component D.
using SpacetimePoint = std::array<double, max_dimension + 1>;

/// Polynomial displacement of total degree <= degree in spacetime, a sum of monomials, with its exact derivatives.
class PolynomialField {
 public:
  PolynomialField(int dimension, int degree);  ///< zero

  static PolynomialField random(int dimension, int degree, std::mt19937& generator);
  /// A translation that depends on time alone: no stress, so it solves the equations for any materials side by side.
  static PolynomialField random_translation(int dimension, int degree, std::mt19937& generator);

  /// Coefficient of the monomial with these exponents (x.., t) in component i.
  double& coefficient(int i, const std::array<int, max_dimension + 1>& exponents);

  double displacement(int i, const SpacetimePoint& point) const;
  double velocity(int i, const SpacetimePoint& point) const;
  double strain(int i, int j, const SpacetimePoint& point) const;
  double stress(int i, int j, const Material& material, const SpacetimePoint& point) const;
  /// rho b = rho v_t - div sigma.
  double body_force(int i, const Material& material, const SpacetimePoint& point) const;

 private:
  double derivative(int i, const SpacetimePoint& point, const std::array<int, max_dimension + 1>& orders) const;

  int dimension_;
  std::vector<std::array<int, max_dimension + 1>> exponents_;
  std::vector<std::vector<double>> coefficients_;  ///< [D][monomial]
};

}  // namespace tentpole
