#pragma once

#include "kernels/element/patch_batch.hpp"
#include "kernels/element/reference_tables.hpp"

namespace tentpole {

/// The rungs beyond the thesis: the own matrix [n][n] of one element, whose vertical sides may be of any kind but
/// fracture, without points (docs/formulation.md, Factors). All throw std::runtime_error for an element that the solver
/// would refuse.

/// Facets as products of factors with one column per facet mode, volume as product of modal factors, all by the BLAS.
void assemble_matrix_product(const PatchBatch& batch, const ReferenceTablesView& tables, int element, double* matrix);

/// Facets as tables int d_l phi_a d_m phi_b, contracted with geometry and material: the assembly of the patch solver.
void assemble_reference_tensor(const PatchBatch& batch, const ReferenceTablesView& tables, int element, double* matrix);

/// `reference_tensor` for elements 0 .. num_elements, a thread for each at a time. matrices [num_elements][n][n].
void assemble_batched(const PatchBatch& batch, const ReferenceTablesView& tables, int num_elements, double* matrices,
                      int num_threads);

}  // namespace tentpole
