#pragma once

#include "bench/assembly/element_updates.hpp"
#include "kernels/element/reference_tables.hpp"

namespace tentpole {

/// Useful operations of one integration cell, the same for every rung: those of the way with the fewest that is known,
/// reference tensors for 1 + D facets, modal volume, rigid modes (multiply and add count as two):
///   2 n^2 [d^2 (1 + D) + C(k - 2 + d, d) + D (D + 1) / 2].
inline double useful_assembly_flops(const ReferenceTablesView& tables) {
  const double n = tables.num_unknowns, D = tables.dimension;
  return 2 * n * n * ((D + 1) * (D + 1) * (1 + D) + tables.num_curvature_modes + D * (D + 1) / 2);
}

/// Operations that a double loop over rows and columns does for one update, and the bytes of the matrix it reads and
/// writes: each entry once in both directions.
inline double update_flops(const UpdateRows& update) {
  return 2.0 * update.num_terms * update.num_unknowns * update.num_unknowns;
}
inline double update_bytes(const UpdateRows& update) {
  return 16.0 * update.num_unknowns * update.num_unknowns;
}

/// The products of `matrix_product`: 2 n^2 [(d + D V) C(k - 1 + D, D) + C(k - 2 + d, d) + D (D + 1) / 2] for one inflow
/// facet and V = D vertical facets.
inline double matrix_product_flops(const ReferenceTablesView& tables) {
  const double n = tables.num_unknowns, D = tables.dimension;
  return 2 * n * n * ((D + 1 + D * D) * tables.num_facet_modes + tables.num_curvature_modes + D * (D + 1) / 2);
}

}  // namespace tentpole
