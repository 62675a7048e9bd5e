#pragma once

#include <vector>

namespace tentpole {

/// Derivatives of the basis at the quadrature points of the reference element, tabulated once: what a program that
/// integrates point by point has before it meets its first element. The rules are the smallest of their kind that are
/// exact: degree 2 k - 3 in the volume and 2 k - 2 on facets, (k - 1)^d and k^(d - 1) points (at least one).
struct CellTables {
  /// space_dimension D = 1..3, spacetime dimension d = D + 1; degree k = 1..7.
  CellTables(int space_dimension, int degree);

  int dimension;                        ///< D
  int degree;                           ///< k
  int num_basis;                        ///< n_b = C(k + d, d)
  int num_unknowns;                     ///< n = D n_b, unknown (i, a) at i n_b + a
  std::vector<double> volume_weight;    ///< [q], sum 1 / d!
  std::vector<double> volume_gradient;  ///< [q][l][a]
  std::vector<double> volume_hessian;   ///< [q][pairs l <= l'][a]
  std::vector<double> facet_weight;     ///< [q], sum 1: means over the facet
  std::vector<double> facet_gradient;   ///< [facet 0..d][q][l][a], the corners of the facet ascending

  int num_volume_points() const { return static_cast<int>(volume_weight.size()); }
  int num_facet_points() const { return static_cast<int>(facet_weight.size()); }
  int num_pairs() const { return (dimension + 1) * (dimension + 2) / 2; }
  const double* gradient_in_volume(int point) const {
    return &volume_gradient[static_cast<long>(point) * (dimension + 1) * num_basis];
  }
  const double* hessian_in_volume(int point) const {
    return &volume_hessian[static_cast<long>(point) * num_pairs() * num_basis];
  }
  const double* gradient_on_facet(int facet, int point) const {
    return &facet_gradient[(static_cast<long>(facet) * num_facet_points() + point) * (dimension + 1) * num_basis];
  }
};

}  // namespace tentpole
