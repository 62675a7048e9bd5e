#include "tests/host/run/polynomial_field.hpp"

#include <algorithm>
#include <cmath>

namespace tentpole::testing {
namespace {

constexpr int time_variable = 3;

}  // namespace

Polynomial Polynomial::monomial(const Exponents& exponents, double coefficient) {
  Polynomial result;
  result.terms_[exponents] = coefficient;
  return result;
}

Polynomial Polynomial::random(const std::vector<int>& variables, int degree, std::mt19937& engine) {
  std::normal_distribution<double> normal;
  Polynomial result = monomial({}, 1.0);
  for (int variable : variables) {
    Exponents first{};
    first[variable] = 1;
    result = result + monomial(first, 1.0);
  }
  Polynomial all = monomial({}, 1.0);  // (1 + x + y + ..)^degree has every monomial
  for (int i = 0; i < degree; ++i) all = all * result;
  for (auto& [exponents, coefficient] : all.terms_) coefficient = normal(engine);
  return all;
}

Polynomial Polynomial::derivative(int variable) const {
  Polynomial result;
  for (const auto& [exponents, coefficient] : terms_) {
    if (exponents[variable] == 0) continue;
    Exponents lower = exponents;
    --lower[variable];
    result.terms_[lower] = exponents[variable] * coefficient;
  }
  return result;
}

Polynomial Polynomial::in_units(const std::array<double, 4>& unit) const {
  Polynomial result = *this;
  for (auto& [exponents, coefficient] : result.terms_)
    for (int variable = 0; variable < 4; ++variable) coefficient /= std::pow(unit[variable], exponents[variable]);
  return result;
}

std::string Polynomial::text() const {
  if (terms_.empty()) return "0";
  int variable = 0;
  const auto has = [&](const auto& term) { return term.first[variable] > 0; };
  while (variable < 4 && std::none_of(terms_.begin(), terms_.end(), has)) ++variable;
  if (variable == 4) return digits(terms_.begin()->second);
  Polynomial constant, rest;  // *this = constant + variable * rest
  for (const auto& [exponents, coefficient] : terms_) {
    if (exponents[variable] == 0) {
      constant.terms_[exponents] = coefficient;
    } else {
      Exponents lower = exponents;
      --lower[variable];
      rest.terms_[lower] = coefficient;
    }
  }
  return "(" + constant.text() + "+" + std::string(1, "xyzt"[variable]) + "*" + rest.text() + ")";
}

Polynomial operator+(Polynomial a, const Polynomial& b) {
  for (const auto& [exponents, coefficient] : b.terms_) a.terms_[exponents] += coefficient;
  return a;
}

Polynomial operator*(double factor, Polynomial polynomial) {
  for (auto& [exponents, coefficient] : polynomial.terms_) coefficient *= factor;
  return polynomial;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [exponents_a, coefficient_a] : a.terms_)
    for (const auto& [exponents_b, coefficient_b] : b.terms_) {
      Polynomial::Exponents sum{};
      for (int variable = 0; variable < 4; ++variable) sum[variable] = exponents_a[variable] + exponents_b[variable];
      result.terms_[sum] += coefficient_a * coefficient_b;
    }
  return result;
}

ExactField polynomial_field(const std::vector<Polynomial>& displacement, const Solid& solid) {
  const int dimension = static_cast<int>(displacement.size());
  Polynomial divergence;
  for (int i = 0; i < dimension; ++i) divergence = divergence + displacement[i].derivative(i);
  ExactField field;
  field.dimension = dimension;
  for (int i = 0; i < dimension; ++i) {
    const Polynomial velocity = displacement[i].derivative(time_variable);
    Polynomial force = velocity.derivative(time_variable);
    std::vector<std::string> row;
    for (int j = 0; j < dimension; ++j) {
      Polynomial stress = solid.mu * (displacement[i].derivative(j) + displacement[j].derivative(i));
      if (i == j) stress = stress + solid.lambda * divergence;
      force = force + (-1 / solid.density) * stress.derivative(j);
      row.push_back(stress.text());
    }
    field.displacement.push_back(displacement[i].text());
    field.velocity.push_back(velocity.text());
    field.stress.push_back(row);
    field.body_force.push_back(force.text());
  }
  return field;
}

}  // namespace tentpole::testing
