#pragma once

#include <iosfwd>
#include <optional>
#include <vector>

#include "common/exact_sum.hpp"
#include "host/case_file/expression.hpp"
#include "host/output/run_summary.hpp"
#include "host/output/spacetime_element.hpp"
#include "kernels/element/quadrature.hpp"

namespace tentpole {

/// Space-time errors against the exact displacement of a case, over all elements added:
///   displacement_l2 = (int |u - u_h|^2)^(1/2),   energy_norm = (int rho |v - v_h|^2 + (E - E_h):C:(E - E_h))^(1/2).
/// The expression is evaluated once per point of a quadrature of degree 2 k + 4, and nothing is differentiated by
/// differences: derivatives are those of its L2 projection on the polynomials of degree k + 2, two degrees above the
/// solution's, so what they miss is smaller than energy_norm by two orders of the mesh size.
class ExactErrors {
 public:
  /// Without an exact solution nothing is measured.
  ExactErrors(const std::optional<VectorExpression>& exact, int dimension, int degree);

  bool active() const { return exact_.has_value(); }
  void add(const SpacetimeElement& element);
  std::optional<RunSummary::Errors> result() const;

  void save(std::ostream& stream) const;
  void load(std::istream& stream);

 private:
  using Coefficients = std::vector<double>;  ///< [i][a] in the orthonormal basis of degree k + 2

  void make_tables();
  Coefficients project_difference(const SpacetimeElement& element, double determinant);
  double energy_density(const SpacetimeElement& element, const ElementFields& fields,
                        const Coefficients& difference) const;

  std::optional<VectorExpression> exact_;
  int dimension_;
  OrthonormalBasis basis_;        ///< of the solution, degree k
  OrthonormalBasis finer_basis_;  ///< degree k + 2; its first functions are those of basis_
  Quadrature rule_;
  std::vector<double> values_;       ///< [point][a], finer basis
  std::vector<double> derivatives_;  ///< [l][b][a]: coefficient b, degree k + 1, of d phi_a / d xi_l
  int num_derivatives_ = 0;          ///< coefficients of degree k + 1
  ExactSum displacement_error_, displacement_, energy_error_;
};

}  // namespace tentpole
