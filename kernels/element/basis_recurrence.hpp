#pragma once

namespace tentpole {

/// Core of the orthonormal (Dubiner) basis of the unit simplex of `dimension` d (orthonormal_basis.hpp), for any number
/// type: double, a register of points, or a number with its derivatives. Direction j = 0..d-1 contributes the factor
///   q_n(x_j, R_j) = sqrt(2 n + alpha + 1) R_j^n P_n^(alpha, 0)(2 x_j / R_j - 1),   R_j = 1 - x_0 - .. - x_{j-1},
/// of its degree n, with alpha = 2 (degree of the later directions) + d - 1 - j, by a three-term recurrence without
/// division:
///   q_{n+1} = (step[0] x + step[1] R) q_n - step[2] R^2 q_{n-1}.
/// Source: Sherwin and Karniadakis, IJNME 38 (1995) 3775.
struct BasisRecurrence {
  int degree;
  const double* rows;  ///< [alpha][q_0, then degree steps of 3], alpha = 0..2 degree + d - 1

  const double* row(int alpha) const { return rows + alpha * (1 + 3 * degree); }
  /// Factors of one direction: a triangle, row `after` (degree of the later directions) with own degrees 0..degree -
  /// after.
  int triangle_size() const { return (degree + 1) * (degree + 2) / 2; }
  int index(int after, int own) const { return after * (degree + 1) - after * (after - 1) / 2 + own; }
};

/// q_0..q_degree of one direction.
template <class Value>
inline void direction_factors(const double* row, int degree, const Value& coordinate, const Value& remainder,
                              Value* factors) {
  factors[0] = Value{} + row[0];
  if (degree == 0) return;
  const Value square = remainder * remainder;
  const double* step = row + 1;
  factors[1] = (step[0] * coordinate + step[1] * remainder) * factors[0];
  for (int n = 1; n < degree; ++n) {
    step += 3;
    factors[n + 1] = (step[0] * coordinate + step[1] * remainder) * factors[n] - step[2] * (square * factors[n - 1]);
  }
}

/// All factors at the point `coordinate` [dimension] into `factors` [dimension][triangle_size].
template <int dimension, class Value>
inline void basis_factors(const BasisRecurrence& recurrence, const Value* coordinate, Value* factors) {
  Value remainder = Value{} + 1.0;
  for (int j = 0; j < dimension; ++j) {
    const int last = j == dimension - 1 ? 0 : recurrence.degree;  // no directions are later than the last
    for (int after = 0; after <= last; ++after)
      direction_factors(recurrence.row(2 * after + dimension - 1 - j), recurrence.degree - after, coordinate[j],
                        remainder, factors + j * recurrence.triangle_size() + recurrence.index(after, 0));
    remainder = remainder - coordinate[j];
  }
}

/// The functions whose directions j.. have total degree `total`, times `product`; the first direction's degree
/// descends.
template <int dimension, int j, class Value, class Visit>
inline void visit_products(const BasisRecurrence& recurrence, const Value* factors, int total, const Value& product,
                           int& function, const Visit& visit) {
  const Value* own_factors = factors + j * recurrence.triangle_size();
  if constexpr (j == dimension - 1) {
    visit(function++, product * own_factors[total]);
  } else {
    for (int own = total; own >= 0; --own)
      visit_products<dimension, j + 1>(recurrence, factors, total - own,
                                       product * own_factors[recurrence.index(total - own, own)], function, visit);
  }
}

/// Calls visit(a, phi_a) for every basis function in order, from the factors of a point. dimension >= 1.
template <int dimension, class Value, class Visit>
inline void for_each_basis_function(const BasisRecurrence& recurrence, const Value* factors, const Visit& visit) {
  int function = 0;
  for (int total = 0; total <= recurrence.degree; ++total)
    visit_products<dimension, 0>(recurrence, factors, total, Value{} + 1.0, function, visit);
}

}  // namespace tentpole
