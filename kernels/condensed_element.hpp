#pragma once

#include "kernels/reference_tables.hpp"

namespace tentpole {

/// Shape of one element's condensed system
///     [ A    P ]      A   [n x n]  volume, inflow and own sides of the vertical facets
///     [ O^T  0 ]      P   how incoming amplitudes load the element, O its outgoing amplitudes,
/// stored row-major with leading dimension `stride`. n and the number of amplitudes are rounded up to multiples of 4
/// (identity and zeros in the padding), so that every tile of the elimination is whole.
struct CondensedShape {
  int num_unknowns;         ///< n
  int unknowns_padded;      ///< first column of P and first row of O^T
  int amplitudes_per_port;  ///< r = D num_facet_modes
  int num_amplitudes;       ///< R = r num_ports
  int amplitudes_padded;
  int rows;    ///< unknowns_padded + amplitudes_padded
  int stride;  ///< >= rows; not a multiple of 128 doubles, which would crowd a few cache sets

  CondensedShape(const ReferenceTablesView& tables, int num_ports)
      : num_unknowns(tables.num_unknowns),
        unknowns_padded((num_unknowns + 3) / 4 * 4),
        amplitudes_per_port(tables.dimension * tables.num_facet_modes),
        num_amplitudes(amplitudes_per_port * num_ports),
        amplitudes_padded((num_amplitudes + 3) / 4 * 4),
        rows(unknowns_padded + amplitudes_padded),
        stride(rows % 32 == 0 ? rows + 4 : rows) {}

  long matrix_size() const { return static_cast<long>(rows) * stride; }
};

}  // namespace tentpole
