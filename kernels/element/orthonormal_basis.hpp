#pragma once

#include <span>
#include <vector>

#include "kernels/element/basis_recurrence.hpp"

namespace tentpole {

/// L2-orthonormal (Dubiner) basis of the complete polynomials of total degree <= degree on the unit simplex
/// { xi_j >= 0, sum xi_j <= 1 } of `dimension` 1..4: int phi_a phi_b dxi = delta_ab. Ordered by total degree, so the
/// first num_polynomials(dimension, p) functions span the polynomials of degree p. Evaluated by three-term recurrences
/// that are polynomials of the coordinates: no singular points, also outside the simplex.
/// Source: Sherwin and Karniadakis, IJNME 38 (1995) 3775.
class OrthonormalBasis {
 public:
  /// Throws std::invalid_argument unless 0 <= dimension <= 4 and degree >= 0 (dimension 0: the constant 1).
  OrthonormalBasis(int dimension, int degree);

  int dimension() const { return dimension_; }
  int degree() const { return degree_; }
  int size() const { return size_; }

  /// value[a] at the reference point xi [dimension].
  void values(std::span<const double> xi, std::span<double> value) const;
  /// gradient[a * dimension + l] = d phi_a / d xi_l at xi.
  void gradients(std::span<const double> xi, std::span<double> gradient) const;
  /// hessian[(a * dimension + l) * dimension + m] = d^2 phi_a / d xi_l d xi_m at xi.
  void hessians(std::span<const double> xi, std::span<double> hessian) const;

  /// Coefficients of the recurrences (basis_recurrence.hpp), for kernels that evaluate the basis on a device.
  const std::vector<double>& recurrence_rows() const { return recurrence_rows_; }

 private:
  BasisRecurrence recurrence() const { return {degree_, recurrence_rows_.data()}; }

  int dimension_;
  int degree_;
  int size_;
  std::vector<double> recurrence_rows_;
};

}  // namespace tentpole
