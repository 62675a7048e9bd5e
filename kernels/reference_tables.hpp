#pragma once

#include <vector>

#include "common/simplex.hpp"

namespace tentpole {

/// Tables of one (dimension, degree) that turn every term of the weak form into small factors (docs/formulation.md,
/// Factors). Notation: phi_a element basis, l a reference coordinate, psi_m orthonormal modes of degree k - 1 on a
/// facet (mean of psi_m psi_n = delta_mn), chi_m the degree-1 modes of a facet, <f> the mean over a facet. Facet
/// corners are listed as patch_batch.hpp says. A plain struct of pointers into one block, in the memory of the device
/// that uses it.
struct ReferenceTablesView {
  int dimension;                      ///< D
  int degree;                         ///< k
  int num_basis;                      ///< n_b = C(k + D + 1, D + 1)
  int num_unknowns;                   ///< n = D n_b
  int num_facet_modes;                ///< C(k - 1 + D, D)
  int num_volume_modes;               ///< polynomials of degree k - 1 on the element
  int num_curvature_modes;            ///< polynomials of degree k - 2 on the element
  int basis_stride;                   ///< n_b rounded up to a multiple of 4
  int facet_stride;                   ///< num_facet_modes rounded up to a multiple of 4 (padding is zero)
  const double* inflow_derivative;    ///< [l][a][m] = <d_l phi_a psi_m>, [D+1][n_b][facet_stride]
  const double* vertical_derivative;  ///< [facet 0..D][l][a][m]
  const double* outflow_derivative;   ///< [pole 0..D][l][a][m]
  const double* inflow_value;         ///< [a][m'] = <phi_a chi_m'>, [n_b][D+1]
  const double* outflow_value;        ///< [pole 0..D][a][m']
  const double* inflow_gram;          ///< [a][l, l'][b] = <d_l phi_a d_l' phi_b>, [n_b][(D+1)^2][basis_stride]
  const double* vertical_gram;        ///< [facet 0..D][a][l, l'][b]
  const double* corner_modes;         ///< [corner][m']: barycentric coordinate of a facet corner in the chi modes
  const double* corner_psi;           ///< [corner][m]: psi_m at the facet corners, [D+1][facet_stride]
  const double* volume_derivative;    ///< [l][a][q] = int d_l phi_a phi_q, q < num_volume_modes
  const double* curvature;            ///< [pair l <= l'][q][b] = int phi_q d_l d_l' phi_b, q < num_curvature_modes
};

/// Owns the tables on the host. Built once per run by quadrature that is exact for every entry.
class ReferenceTables {
 public:
  /// Throws std::invalid_argument unless 1 <= dimension <= 3 and 1 <= degree <= max_degree.
  ReferenceTables(int dimension, int degree);

  /// The whole block, to be copied to a device.
  const std::vector<double>& block() const { return block_; }
  /// Tables at a copy of the block that starts at `base`.
  ReferenceTablesView view(const double* base) const;
  ReferenceTablesView view() const { return view(block_.data()); }

 private:
  std::vector<double> block_;
  ReferenceTablesView offsets_{};  ///< sizes; pointers hold no address
  std::vector<std::size_t> offset_;
};

}  // namespace tentpole
