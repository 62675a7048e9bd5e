#pragma once

#include <array>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "tests/host/run/exact_field.hpp"

namespace tentpole::testing {

/// A polynomial in x, y, z, t (variables 0..3).
class Polynomial {
 public:
  using Exponents = std::array<int, 4>;

  Polynomial() = default;
  static Polynomial monomial(const Exponents& exponents, double coefficient);
  /// All monomials up to the degree in some variables, with normally distributed coefficients.
  static Polynomial random(const std::vector<int>& variables, int degree, std::mt19937& engine);

  Polynomial derivative(int variable) const;
  /// Written by Horner's rule, "0" where there are no terms.
  std::string text() const;
  /// The same function of coordinates in other units: coefficients divided by unit[variable]^exponent.
  Polynomial in_units(const std::array<double, 4>& unit) const;

  friend Polynomial operator+(Polynomial a, const Polynomial& b);
  friend Polynomial operator*(double factor, Polynomial polynomial);
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);

 private:
  std::map<Exponents, double> terms_;
};

/// The displacement as a solution: velocity, stress, and the body force that balances them.
ExactField polynomial_field(const std::vector<Polynomial>& displacement, const Solid& solid);

}  // namespace tentpole::testing
