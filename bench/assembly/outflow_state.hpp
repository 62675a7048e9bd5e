#pragma once

#include "bench/assembly/cell_tables.hpp"
#include "kernels/element/patch_batch.hpp"

namespace tentpole {

/// What the thesis's post-processing finds on the outflow facets of an element, point by point.
struct OutflowState {
  double energy = 0;                ///< int 1/2 w^T A_N w [scaled], exact
  double largest_principal_stress;  ///< at the quadrature points
};

/// coefficients [n] of the element. Lowest stress -infinity where the element has no outflow facet.
OutflowState outflow_state(const CellTables& tables, const PatchBatch& batch, int element, const double* coefficients);

}  // namespace tentpole
