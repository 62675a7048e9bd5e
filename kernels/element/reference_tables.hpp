#pragma once

#include <vector>

#include "common/simplex.hpp"

namespace tentpole {

/// Tables of one (dimension, degree) that turn every term of the weak form into small factors (docs/formulation.md,
/// Factors). Notation: phi_a element basis, l a reference coordinate, psi_m orthonormal modes of degree k - 1 on a
/// facet (mean of psi_m psi_n = delta_mn), chi_m the degree-1 modes of a facet, <f> the mean over a facet. Facet
/// corners are listed as patch_batch.hpp says. A plain struct of pointers into one block, in the memory of the device
/// that uses it.
///
/// Facets are named by a code (patch_batch.hpp): j = 0..D+1 is the facet opposite corner j with its corners ascending,
/// D + 2 + p the facet opposite corner p of a tent element with the top in place of corner p.
struct ReferenceTablesView {
  int dimension;                    ///< D
  int degree;                       ///< k
  int num_basis;                    ///< n_b = C(k + D + 1, D + 1)
  int num_unknowns;                 ///< n = D n_b
  int num_facet_modes;              ///< C(k - 1 + D, D)
  int num_volume_modes;             ///< polynomials of degree k - 1 on the element
  int num_curvature_modes;          ///< polynomials of degree k - 2 on the element
  int basis_stride;                 ///< n_b rounded up to a multiple of 4
  int facet_stride;                 ///< num_facet_modes rounded up to a multiple of 4 (padding is zero)
  const double* derivative;         ///< [code][l][a][m] = <d_l phi_a psi_m>, [2 D + 3][D+1][n_b][facet_stride]
  const double* value;              ///< [code][a][m'] = <phi_a chi_m'>, [2 D + 3][n_b][D+1]
  const double* gram;               ///< [facet 0..D+1][a][l, l'][b] = <d_l phi_a d_l' phi_b>, last basis_stride
  int num_lines;                    ///< of a fracture facet: k + 1 Gauss points along the front edge, D = 1: one
  int num_panel_points;             ///< Gauss points in a panel of a line: max(3, k)
  const double* line_point;         ///< [num_lines] on [0, 1]
  const double* line_weight;        ///< [num_lines], sum 1
  const double* panel_point;        ///< [num_panel_points] on [0, 1]
  const double* panel_weight;       ///< [num_panel_points], sum 1
  const double* facet_recurrence;   ///< rows of BasisRecurrence of dimension D, degree k - 1
  const double* corner_modes;       ///< [corner][m']: barycentric coordinate of a facet corner in the chi modes
  const double* corner_psi;         ///< [corner][m]: psi_m at the facet corners, [D+1][facet_stride]
  const double* volume_derivative;  ///< [l][a][q] = int d_l phi_a phi_q, q < num_volume_modes
  const double* curvature;          ///< [pair l <= l'][q][b] = int phi_q d_l d_l' phi_b, q < num_curvature_modes

  const double* facet_derivative(int code) const {
    return derivative + static_cast<long>(code) * (dimension + 1) * num_basis * facet_stride;
  }
  const double* facet_value(int code) const { return value + static_cast<long>(code) * num_basis * (dimension + 1); }
  const double* facet_gram(int facet) const {
    return gram + static_cast<long>(facet) * num_basis * (dimension + 1) * (dimension + 1) * basis_stride;
  }
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
