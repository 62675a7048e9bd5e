#pragma once

#include "kernels/connect_elements.hpp"
#include "kernels/cycle_counter.hpp"
#include "kernels/eliminate.hpp"
#include "kernels/fracture_record.hpp"
#include "kernels/larger_or_nan.hpp"
#include "kernels/post_processing.hpp"

namespace tentpole {

/// Transposes the square response block of an element in place, so that products with it run along rows.
template <class Lanes>
inline void transpose_response(const CondensedShape& shape, double* matrix, const Lanes& lanes) {
  double* block = matrix + static_cast<long>(shape.unknowns_padded) * shape.stride + shape.unknowns_padded;
  for (int row = lanes.first(); row < shape.amplitudes_padded; row += lanes.count())
    for (int column = 0; column < row; ++column) {
      double& lower = block[static_cast<long>(row) * shape.stride + column];
      double& upper = block[static_cast<long>(column) * shape.stride + row];
      const double keep = lower;
      lower = upper;
      upper = keep;
    }
}

/// The rigid modes with which the neighbours across the inclined facets of an element take its displacement.
template <int D>
struct Receivers {
  const RigidFacet<D>* rigid[InclinedFacet<D>::max_per_element];
};
template <int D>
inline Receivers<D> receivers_of(const PatchDescriptor& patch, const PatchWorkspace<D>& workspace,
                                 const ElementDescriptor& element, const ElementOperator<D>& op) {
  Receivers<D> receivers{};
  for (int f = 0; f < op.num_inclined; ++f) {
    const int facet = op.inclined[f].facet;
    const ElementOperator<D>& other = *workspace.element(element.neighbor[facet] - patch.first_element).op;
    for (int g = 0; g < other.num_inclined; ++g)
      if (other.inclined[g].facet == element.neighbor_facet[facet] && other.inclined[g].rigid != none)
        receivers.rigid[f] = &other.rigid[other.inclined[g].rigid];
  }
  return receivers;
}

/// Builds the operators of all elements before any is assembled: across an inclined facet an element needs its
/// neighbour's. Returns the first status that is not ok.
template <int D, class Lanes>
inline Status build_operators(const PatchBatch& batch, const PatchDescriptor& patch, const PatchWorkspace<D>& workspace,
                              const Lanes& lanes) {
  for (int e = lanes.first(); e < patch.num_elements; e += lanes.count()) {
    ElementOperator<D>& op = *workspace.element(e).op;
    op.status = build_element_operator<D>(batch, workspace.tables, patch.is_general != 0,
                                          batch.elements[patch.first_element + e], op);
  }
  lanes.synchronize();
  Status status = Status::ok;
  for (int e = 0; e < patch.num_elements && status == Status::ok; ++e) status = workspace.element(e).op->status;
  return status;
}

/// Assembles one element and its right-hand side.
template <int D, class Lanes>
inline void assemble_patch_element(const PatchBatch& batch, const PatchDescriptor& patch,
                                   const PatchWorkspace<D>& workspace, int e, const Lanes& lanes) {
  const ReferenceTablesView& tables = workspace.tables;
  const ElementDescriptor& element = batch.elements[patch.first_element + e];
  const ElementWorkspace<D> own = workspace.element(e);
  const ElementOperator<D>& op = *own.op;
  load_inflow_data<D>(batch, tables, element, op, workspace.residual_scratch(), own.inflow_data, lanes);
  lanes.synchronize();
  const CondensedShape shape = workspace.shape(own);
  const Receivers<D> receivers = receivers_of<D>(patch, workspace, element, op);
  assemble_element<D>(op, tables, shape, receivers.rigid, workspace.volume_factors(), own.matrix, lanes);
  for (int unknown = lanes.first(); unknown < shape.unknowns_padded; unknown += lanes.count()) {
    own.diagonal[unknown] = own.matrix[static_cast<long>(unknown) * shape.stride + unknown];
    own.solution[unknown] = 0;
  }
  lanes.synchronize();
  element_residual<D>(op, tables, shape, nullptr, nullptr, own.inflow_data, body_force_block(batch, element),
                      batch.prescribed, workspace.residual_scratch(), own.right, lanes);
}

/// right = L^-1 right, outgoing = (O^T U^-1) right: what the element emits without incoming waves.
template <int D, class Lanes>
inline void condense_right_side(const ElementWorkspace<D>& own, const CondensedShape& shape, double* outgoing,
                                const Lanes& lanes) {
  forward_substitute(shape, own.matrix, own.right, lanes);
  for (int row = lanes.first(); row < shape.num_amplitudes; row += lanes.count())
    outgoing[row] = dot(own.matrix + static_cast<long>(shape.unknowns_padded + row) * shape.stride, own.right,
                        shape.unknowns_padded);
  lanes.synchronize();
}

/// solution += U^-1 (right + L^-1 P x).
template <int D, class Lanes>
inline void recover_solution(const ElementWorkspace<D>& own, const CondensedShape& shape, const double* incoming,
                             const Lanes& lanes) {
  for (int row = lanes.first(); row < shape.unknowns_padded; row += lanes.count())
    own.right[row] +=
        dot(own.matrix + static_cast<long>(row) * shape.stride + shape.unknowns_padded, incoming, shape.num_amplitudes);
  lanes.synchronize();
  back_substitute(shape, own.matrix, own.right, lanes);
  for (int row = lanes.first(); row < shape.unknowns_padded; row += lanes.count()) own.solution[row] += own.right[row];
  lanes.synchronize();
}

/// What every element emits without incoming waves, for the right-hand sides held in `right`.
template <int D, class Lanes>
inline void condense_all(const PatchWorkspace<D>& workspace, const AmplitudeSystem& system, const Lanes& lanes) {
  for (int e = 0; e < system.num_elements; ++e) {
    const ElementWorkspace<D> own = workspace.element(e);
    condense_right_side<D>(own, workspace.shape(own), workspace.outgoing() + system.offset(e), lanes);
  }
}

/// Recovers the coefficients of all elements from the incoming amplitudes.
template <int D, class Lanes>
inline void recover_all(const PatchWorkspace<D>& workspace, const AmplitudeSystem& system, const Lanes& lanes) {
  for (int e = 0; e < system.num_elements; ++e) {
    const ElementWorkspace<D> own = workspace.element(e);
    recover_solution<D>(own, workspace.shape(own), workspace.incoming() + system.offset(e), lanes);
  }
}

/// One pass of trace condensation for the right-hand sides held in `right`; adds to `solution`. Returns the iterations
/// of the coupling, or -1.
template <int D, class Lanes>
inline int solve_condensed(const PatchWorkspace<D>& workspace, const AmplitudeSystem& system, const Lanes& lanes) {
  condense_all<D>(workspace, system, lanes);
  const CouplingScratch scratch = CouplingScratch::at(workspace.coupling(), system.size());
  const int iterations = solve_coupling(system, workspace.outgoing(), workspace.incoming(), scratch, lanes);
  recover_all<D>(workspace, system, lanes);
  return iterations;
}

/// The same for a patch with fracture facets: the coupling is solved in rounds; leaves their last maps in place.
template <int D, class Lanes>
inline DamageLoop solve_condensed_fractures(const PatchBatch& batch, const PatchDescriptor& patch,
                                            const PatchWorkspace<D>& workspace, const AmplitudeSystem& system,
                                            const Lanes& lanes) {
  prepare_fractures<D>(batch, patch, workspace, system, lanes);
  condense_all<D>(workspace, system, lanes);
  const DamageLoop loop = solve_fractures<D>(batch, patch, workspace, system, lanes);
  recover_all<D>(workspace, system, lanes);
  return loop;
}

/// Largest |r_i| / sqrt(A_ii) and the scale max(|c_i| sqrt(A_ii)) of one element.
struct ScaledNorms {
  double residual;
  double solution;
};
template <int D>
inline ScaledNorms scaled_norms(const ElementWorkspace<D>& own, int num_unknowns) {
  ScaledNorms norms{0, 0};
  for (int unknown = 0; unknown < num_unknowns; ++unknown) {
    const double root = sqrt(own.diagonal[unknown]);
    norms.residual = larger_or_nan(norms.residual, fabs(own.right[unknown]) / root);
    norms.solution = larger_or_nan(norms.solution, fabs(own.solution[unknown]) * root);
  }
  return norms;
}

/// The waves that the elements emit with their solutions.
template <int D, class Lanes>
inline void emit_all(const PatchBatch& batch, const PatchDescriptor& patch, const PatchWorkspace<D>& workspace,
                     const AmplitudeSystem& system, const Lanes& lanes) {
  for (int e = 0; e < patch.num_elements; ++e) {
    const ElementWorkspace<D> own = workspace.element(e);
    const Receivers<D> receivers = receivers_of<D>(patch, workspace, batch.elements[patch.first_element + e], *own.op);
    emitted_amplitudes<D>(*own.op, receivers.rigid, workspace.tables, workspace.shape(own), own.solution,
                          workspace.residual_scratch(), workspace.outgoing() + system.offset(e), lanes);
  }
}

/// Residuals of all elements with the amplitudes their neighbours really emit; fills the records. Returns the largest
/// residual relative to the largest solution of the patch (both diagonally scaled).
template <int D, class Lanes>
inline double evaluate_patch(const PatchBatch& batch, const PatchDescriptor& patch, const PatchWorkspace<D>& workspace,
                             const AmplitudeSystem& system, const Lanes& lanes) {
  const ReferenceTablesView& tables = workspace.tables;
  emit_all<D>(batch, patch, workspace, system, lanes);
  exchange_amplitudes(system, all_places(system), workspace.outgoing(), workspace.incoming(), lanes);
  double largest_residual = 0, largest_solution = 0;
  for (int e = 0; e < patch.num_elements; ++e) {
    const ElementDescriptor& element = batch.elements[patch.first_element + e];
    const ElementWorkspace<D> own = workspace.element(e);
    const CondensedShape shape = workspace.shape(own);
    const ElementBalance balance = element_residual<D>(
        *own.op, tables, shape, own.solution, workspace.incoming() + system.offset(e), own.inflow_data,
        body_force_block(batch, element), batch.prescribed, workspace.residual_scratch(), own.right, lanes);
    const ScaledNorms norms = scaled_norms<D>(own, shape.num_unknowns);
    largest_residual = larger_or_nan(largest_residual, norms.residual);
    largest_solution = larger_or_nan(largest_solution, norms.solution);
    if (lanes.first() == 0) {
      ElementRecord& record = batch.records[patch.first_element + e];
      record.dissipation = balance.dissipation;
      record.external_work = balance.external_work;
      record.residual = norms.residual;
    }
    lanes.synchronize();
  }
  // Far below a wave's foot data may be denormal numbers, which have no relative accuracy to ask for.
  constexpr double negligible = 1e-140;
  if (largest_residual <= negligible && largest_solution <= negligible) return 0.0;
  return largest_solution > 0 ? largest_residual / largest_solution : 1.0;
}

/// Solves one patch (docs/formulation.md, The patch solver): assemble and condense every element, couple the
/// amplitudes (in rounds with damage and contact where there are fracture facets), recover the coefficients, check the
/// residual, refine at most once, store coefficients and records.
template <int D, class Lanes>
inline void solve_patch(const PatchBatch& batch, const ReferenceTablesView& tables, int patch_index, double* scratch,
                        StageCycles& cycles, const Lanes& lanes) {
  constexpr double residual_tolerance = 1e-12;
  const PatchDescriptor patch = batch.patches[patch_index];
  const PatchWorkspace<D> workspace{tables, patch, lanes.count(), scratch};
  const long long begun = cycle_counter();
  Status status = build_operators<D>(batch, patch, workspace, lanes);
  cycles.assembly += cycle_counter() - begun;
  for (int e = 0; e < patch.num_elements && status == Status::ok; ++e) {
    const long long start = cycle_counter();
    const ElementWorkspace<D> own = workspace.element(e);
    assemble_patch_element<D>(batch, patch, workspace, e, lanes);
    const long long assembled = cycle_counter();
    cycles.assembly += assembled - start;
    const CondensedShape shape = workspace.shape(own);
    if (!eliminate_element(shape, own.matrix, workspace.packed(), lanes)) status = Status::singular_pivot;
    lanes.synchronize();
    transpose_response(shape, own.matrix, lanes);
    lanes.synchronize();
    cycles.solution += cycle_counter() - assembled;
  }
  if (status != Status::ok) {
    mark_failed(batch, patch, status, lanes);
    return;
  }
  const long long condensed = cycle_counter();
  const AmplitudeSystem system = connect_elements<D>(batch, patch, workspace, lanes);
  DamageLoop loop;
  if (patch.num_fractures == 0) loop.iterations = solve_condensed<D>(workspace, system, lanes);
  if constexpr (D < 3)
    if (patch.num_fractures > 0) {
      loop = solve_condensed_fractures<D>(batch, patch, workspace, system, lanes);
      if (!loop.has_converged) return mark_failed(batch, patch, Status::damage_not_converged, lanes);
    }
  int iterations = loop.iterations;
  const long long solved = cycle_counter();
  cycles.solution += solved - condensed;
  double residual = evaluate_patch<D>(batch, patch, workspace, system, lanes);
  if (!(residual <= residual_tolerance) || iterations < 0) {
    iterations = solve_condensed<D>(workspace, system, lanes);
    residual = evaluate_patch<D>(batch, patch, workspace, system, lanes);
  }
  if (!(residual <= residual_tolerance))
    status = iterations < 0 ? Status::coupling_not_converged : Status::residual_too_large;
  if constexpr (D < 3) record_fractures<D>(batch, patch, workspace, loop.rounds, status, lanes);
  for (int e = 0; e < patch.num_elements; ++e) {
    const ElementWorkspace<D> own = workspace.element(e);
    post_process<D>(batch, tables, patch.first_element + e, *own.op, own.solution, own.inflow_data,
                    workspace.residual_scratch(), residual, status, iterations, lanes);
  }
  cycles.post_solution += cycle_counter() - solved;
}

/// Residuals, energies and records of a patch whose coefficients are in the element store (found by other means).
template <int D, class Lanes>
inline void check_patch(const PatchBatch& batch, const ReferenceTablesView& tables, int patch_index, double* scratch,
                        const Lanes& lanes) {
  constexpr double residual_tolerance = 1e-8;
  const PatchDescriptor patch = batch.patches[patch_index];
  const PatchWorkspace<D> workspace{tables, patch, lanes.count(), scratch};
  const Status built = build_operators<D>(batch, patch, workspace, lanes);
  if (built != Status::ok) return mark_failed(batch, patch, built, lanes);
  for (int e = 0; e < patch.num_elements; ++e) {
    const ElementWorkspace<D> own = workspace.element(e);
    assemble_patch_element<D>(batch, patch, workspace, e, lanes);
    const long slot = batch.elements[patch.first_element + e].result_slot;
    for (int unknown = lanes.first(); unknown < tables.num_unknowns; unknown += lanes.count())
      own.solution[unknown] = batch.coefficients[slot * tables.num_unknowns + unknown];
  }
  const AmplitudeSystem system = connect_elements<D>(batch, patch, workspace, lanes);
  if constexpr (D < 3)
    if (patch.num_fractures > 0) {
      prepare_fractures<D>(batch, patch, workspace, system, lanes);
      emit_all<D>(batch, patch, workspace, system, lanes);
      integrate_fractures<D>(batch, patch, workspace, workspace.outgoing(), lanes);
      accept_round<D>(batch, patch, workspace, 0, false, lanes);
    }
  const double residual = evaluate_patch<D>(batch, patch, workspace, system, lanes);
  const Status status = residual <= residual_tolerance ? Status::ok : Status::residual_too_large;
  if constexpr (D < 3) record_fractures<D>(batch, patch, workspace, 0, status, lanes);
  for (int e = 0; e < patch.num_elements; ++e) {
    const ElementWorkspace<D> own = workspace.element(e);
    post_process<D>(batch, tables, patch.first_element + e, *own.op, own.solution, own.inflow_data,
                    workspace.residual_scratch(), residual, status, 0, lanes);
  }
}

}  // namespace tentpole
