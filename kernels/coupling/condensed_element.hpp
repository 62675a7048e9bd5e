#pragma once

#include "kernels/element/reference_tables.hpp"

namespace tentpole {

/// Sizes that all elements of a patch share.
struct PatchShape {
  int max_ports;            ///< interior facets of an element at most
  int amplitudes_per_port;  ///< slots for the waves that pass through one of them in one direction

  PatchShape(const ReferenceTablesView& tables, bool is_general) {
    const int dimension = tables.dimension, num_waves = dimension == 1 ? 2 : 5;
    max_ports = is_general ? dimension + 1 : dimension;
    amplitudes_per_port =
        is_general ? num_waves * tables.num_facet_modes + num_symmetric(dimension) : dimension * tables.num_facet_modes;
  }
};

/// Shape of one element's condensed system
///     [ A    P  b ]      A   [n x n]  volume, inflow and own sides of the vertical facets
///     [ O^T  0  0 ]      P   how incoming amplitudes load the element, O its outgoing amplitudes, b the right-hand
///     side
/// stored row-major with leading dimension `stride`. n, the number of amplitudes and the one right-hand side are
/// rounded up to multiples of 4 (identity and zeros in the padding), so that every tile of the elimination is whole.
struct CondensedShape {
  int num_unknowns;         ///< n
  int unknowns_padded;      ///< first column of P and first row of O^T
  int vertical_amplitudes;  ///< r = D num_facet_modes: of a vertical facet
  int amplitudes_per_port;  ///< r, or more in a general patch: room for the waves and rigid modes of an inclined facet
  int num_amplitudes;       ///< R = amplitudes_per_port num_ports
  int amplitudes_padded;
  int rows;     ///< unknowns_padded + amplitudes_padded; also the column of b
  int columns;  ///< rows + 4
  int stride;   ///< >= columns; not a multiple of 32 doubles, which would crowd a few cache sets

  CondensedShape(const ReferenceTablesView& tables, const PatchShape& patch, int num_ports)
      : num_unknowns(tables.num_unknowns),
        unknowns_padded((num_unknowns + 3) / 4 * 4),
        vertical_amplitudes(tables.dimension * tables.num_facet_modes),
        amplitudes_per_port(patch.amplitudes_per_port),
        num_amplitudes(amplitudes_per_port * num_ports),
        amplitudes_padded((num_amplitudes + 3) / 4 * 4),
        rows(unknowns_padded + amplitudes_padded),
        columns(rows + 4),
        stride(columns % 32 == 0 ? columns + 4 : columns) {}

  int right_column() const { return rows; }

  long matrix_size() const { return static_cast<long>(rows) * stride; }
};

}  // namespace tentpole
