#pragma once

#include "kernels/amplitude_coupling.hpp"
#include "kernels/cycle_counter.hpp"
#include "kernels/element_residual.hpp"
#include "kernels/eliminate.hpp"
#include "kernels/post_processing.hpp"

namespace tentpole {

/// Memory of one element while its patch is solved.
template <int D>
struct ElementWorkspace {
  ElementOperator<D>* op;
  double* matrix;       ///< condensed matrix
  double* diagonal;     ///< of A before elimination [unknowns_padded]
  double* right;        ///< b or residual, then L^-1 of it [unknowns_padded]
  double* solution;     ///< c [unknowns_padded]
  double* inflow_data;  ///< layout of an initial data block
};

/// All scratch of one patch: a block per element, then arrays shared by its elements, then the coupling solver.
template <int D>
struct PatchWorkspace {
  static constexpr int max_ports = D;
  ReferenceTablesView tables;
  int num_elements;
  double* memory;

  static long padded(long n) { return (n + 7) / 8 * 8; }
  static long inflow_size(const ReferenceTablesView& tables) {
    return padded((D + num_symmetric(D)) * tables.num_facet_modes + D * (D + 1));
  }
  static long element_size(const ReferenceTablesView& tables) {
    const CondensedShape shape(tables, max_ports);
    return padded(sizeof(ElementOperator<D>) / sizeof(double) + 1) + padded(shape.matrix_size()) +
           3 * padded(shape.unknowns_padded) + inflow_size(tables);
  }
  static long shared_size(const ReferenceTablesView& tables) {
    const CondensedShape shape(tables, max_ports);
    return padded(VolumeFactors::size(tables)) + padded(ResidualScratch::size(tables)) +
           padded(8L * shape.unknowns_padded);
  }
  /// Doubles needed by a patch of `num_elements`, solved by `lanes` lanes.
  static long size(const ReferenceTablesView& tables, int num_elements, int lanes) {
    const int amplitudes = num_elements * max_ports * D * tables.num_facet_modes;
    const long indices = padded(num_elements * (2L + max_ports));
    return num_elements * element_size(tables) + shared_size(tables) + 2 * padded(amplitudes) + indices +
           padded(CouplingScratch::size(amplitudes, lanes));
  }

  ElementWorkspace<D> element(int local) const {
    const CondensedShape shape(tables, max_ports);
    double* next = memory + local * element_size(tables);
    const auto take = [&next](long count) {
      double* start = next;
      next += padded(count);
      return start;
    };
    ElementWorkspace<D> workspace;
    workspace.op = reinterpret_cast<ElementOperator<D>*>(take(sizeof(ElementOperator<D>) / sizeof(double) + 1));
    workspace.matrix = take(shape.matrix_size());
    workspace.diagonal = take(shape.unknowns_padded);
    workspace.right = take(shape.unknowns_padded);
    workspace.solution = take(shape.unknowns_padded);
    workspace.inflow_data = take(inflow_size(tables));
    return workspace;
  }
  double* volume_factors() const { return memory + num_elements * element_size(tables); }
  double* residual_scratch() const { return volume_factors() + padded(VolumeFactors::size(tables)); }
  double* packed() const { return residual_scratch() + padded(ResidualScratch::size(tables)); }
  int num_amplitudes() const { return num_elements * max_ports * D * tables.num_facet_modes; }
  double* outgoing() const { return volume_factors() + shared_size(tables); }
  double* incoming() const { return outgoing() + padded(num_amplitudes()); }
  const double** responses() const { return reinterpret_cast<const double**>(incoming() + padded(num_amplitudes())); }
  int* integers() const { return reinterpret_cast<int*>(responses() + num_elements); }
  double* coupling() const { return incoming() + padded(num_amplitudes()) + padded(num_elements * (2L + max_ports)); }
};

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

/// Which entry of the outgoing amplitudes feeds each port, and where each element's response block lies.
template <int D, class Lanes>
inline AmplitudeSystem amplitude_system(const PatchBatch& batch, const PatchDescriptor& patch,
                                        const PatchWorkspace<D>& workspace, const Lanes& lanes) {
  constexpr int max_ports = PatchWorkspace<D>::max_ports;
  AmplitudeSystem system;
  system.num_elements = patch.num_elements;
  system.amplitudes_per_port = D * workspace.tables.num_facet_modes;
  system.max_ports = max_ports;
  system.max_amplitudes = max_ports * system.amplitudes_per_port;
  const double** response = workspace.responses();
  int* response_stride = workspace.integers();
  int* num_amplitudes = response_stride + patch.num_elements;
  int* source = num_amplitudes + patch.num_elements;
  for (int e = lanes.first(); e < patch.num_elements; e += lanes.count()) {
    const ElementDescriptor& element = batch.elements[patch.first_element + e];
    const ElementWorkspace<D> own = workspace.element(e);
    const CondensedShape shape(workspace.tables, own.op->num_ports);
    response[e] = own.matrix + static_cast<long>(shape.unknowns_padded) * shape.stride + shape.unknowns_padded;
    response_stride[e] = shape.stride;
    num_amplitudes[e] = shape.num_amplitudes;
    for (int port = 0; port < max_ports; ++port) source[e * max_ports + port] = none;
    for (int f = 0; f < own.op->num_vertical; ++f) {
      const VerticalFacet<D>& vertical = own.op->vertical[f];
      if (vertical.port == none) continue;
      const int other = element.neighbor[vertical.facet] - patch.first_element;
      const ElementOperator<D>& other_op = *workspace.element(other).op;
      for (int g = 0; g < other_op.num_vertical; ++g)
        if (other_op.vertical[g].facet == element.neighbor_facet[vertical.facet])
          source[e * max_ports + vertical.port] =
              other * system.max_amplitudes + other_op.vertical[g].port * system.amplitudes_per_port;
    }
  }
  system.response = response;
  system.response_stride = response_stride;
  system.num_amplitudes = num_amplitudes;
  system.source = source;
  lanes.synchronize();
  return system;
}

/// Assembles one element and its right-hand side.
template <int D, class Lanes>
inline Status assemble_patch_element(const PatchBatch& batch, const PatchWorkspace<D>& workspace,
                                     const ElementDescriptor& element, const ElementWorkspace<D>& own,
                                     const Lanes& lanes) {
  const ReferenceTablesView& tables = workspace.tables;
  Status status = Status::ok;
  ElementOperator<D> op;
  status = build_element_operator<D>(batch, tables, element, op);
  if (status != Status::ok) return status;
  if (lanes.first() == 0) *own.op = op;
  load_inflow_data<D>(batch, tables, element, workspace.residual_scratch(), own.inflow_data, lanes);
  lanes.synchronize();
  const CondensedShape shape(tables, op.num_ports);
  assemble_element<D>(op, tables, shape, workspace.volume_factors(), own.matrix, lanes);
  for (int unknown = lanes.first(); unknown < shape.unknowns_padded; unknown += lanes.count()) {
    own.diagonal[unknown] = own.matrix[static_cast<long>(unknown) * shape.stride + unknown];
    own.solution[unknown] = 0;
  }
  lanes.synchronize();
  element_residual<D>(op, tables, shape, nullptr, nullptr, own.inflow_data, body_force_block(batch, element),
                      batch.prescribed, workspace.residual_scratch(), own.right, lanes);
  return status;
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

/// One pass of trace condensation for the right-hand sides held in `right`; adds to `solution`. Returns the iterations
/// of the coupling, or -1.
template <int D, class Lanes>
inline int solve_condensed(const PatchWorkspace<D>& workspace, const AmplitudeSystem& system, const Lanes& lanes) {
  for (int e = 0; e < system.num_elements; ++e) {
    const ElementWorkspace<D> own = workspace.element(e);
    condense_right_side<D>(own, CondensedShape(workspace.tables, own.op->num_ports),
                           workspace.outgoing() + e * system.max_amplitudes, lanes);
  }
  exchange_amplitudes(system, workspace.outgoing(), workspace.incoming(), lanes);
  const int iterations =
      solve_coupling(system, workspace.incoming(), CouplingScratch::at(workspace.coupling(), system.size()), lanes);
  for (int e = 0; e < system.num_elements; ++e) {
    const ElementWorkspace<D> own = workspace.element(e);
    recover_solution<D>(own, CondensedShape(workspace.tables, own.op->num_ports),
                        workspace.incoming() + e * system.max_amplitudes, lanes);
  }
  return iterations;
}

/// The larger number; not a number if one of them is not (fmax would pass over it).
inline double larger_or_nan(double a, double b) {
  return b > a || b != b ? b : a;
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

/// Residuals of all elements with the amplitudes their neighbours really emit; fills the records. Returns the largest
/// residual relative to the largest solution of the patch (both diagonally scaled).
template <int D, class Lanes>
inline double evaluate_patch(const PatchBatch& batch, const PatchDescriptor& patch, const PatchWorkspace<D>& workspace,
                             const AmplitudeSystem& system, const Lanes& lanes) {
  const ReferenceTablesView& tables = workspace.tables;
  for (int e = 0; e < patch.num_elements; ++e) {
    const ElementWorkspace<D> own = workspace.element(e);
    emitted_amplitudes<D>(*own.op, tables, own.solution, workspace.residual_scratch(),
                          workspace.outgoing() + e * system.max_amplitudes, lanes);
  }
  exchange_amplitudes(system, workspace.outgoing(), workspace.incoming(), lanes);
  double largest_residual = 0, largest_solution = 0;
  for (int e = 0; e < patch.num_elements; ++e) {
    const ElementDescriptor& element = batch.elements[patch.first_element + e];
    const ElementWorkspace<D> own = workspace.element(e);
    const CondensedShape shape(tables, own.op->num_ports);
    const ElementBalance balance = element_residual<D>(
        *own.op, tables, shape, own.solution, workspace.incoming() + e * system.max_amplitudes, own.inflow_data,
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
/// amplitudes, recover the coefficients, check the residual, refine at most once, store coefficients and records.
template <int D, class Lanes>
inline void solve_patch(const PatchBatch& batch, const ReferenceTablesView& tables, int patch_index, double* scratch,
                        StageCycles& cycles, const Lanes& lanes) {
  constexpr double residual_tolerance = 1e-12;
  const PatchDescriptor patch = batch.patches[patch_index];
  const PatchWorkspace<D> workspace{tables, patch.num_elements, scratch};
  Status status = Status::ok;
  for (int e = 0; e < patch.num_elements; ++e) {
    const long long start = cycle_counter();
    const ElementWorkspace<D> own = workspace.element(e);
    status = assemble_patch_element<D>(batch, workspace, batch.elements[patch.first_element + e], own, lanes);
    const long long assembled = cycle_counter();
    cycles.assembly += assembled - start;
    if (status != Status::ok) break;
    if (!eliminate_element(CondensedShape(tables, own.op->num_ports), own.matrix, workspace.packed(), lanes)) {
      status = Status::singular_pivot;
      break;
    }
    lanes.synchronize();
    transpose_response(CondensedShape(tables, own.op->num_ports), own.matrix, lanes);
    lanes.synchronize();
    cycles.solution += cycle_counter() - assembled;
  }
  if (status != Status::ok) {
    mark_failed(batch, patch, status, lanes);
    return;
  }
  const long long condensed = cycle_counter();
  const AmplitudeSystem system = amplitude_system<D>(batch, patch, workspace, lanes);
  int iterations = solve_condensed<D>(workspace, system, lanes);
  const long long solved = cycle_counter();
  cycles.solution += solved - condensed;
  double residual = evaluate_patch<D>(batch, patch, workspace, system, lanes);
  if (!(residual <= residual_tolerance) || iterations < 0) {
    iterations = solve_condensed<D>(workspace, system, lanes);
    residual = evaluate_patch<D>(batch, patch, workspace, system, lanes);
  }
  if (!(residual <= residual_tolerance))
    status = iterations < 0 ? Status::coupling_not_converged : Status::residual_too_large;
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
  const PatchWorkspace<D> workspace{tables, patch.num_elements, scratch};
  for (int e = 0; e < patch.num_elements; ++e) {
    const ElementDescriptor& element = batch.elements[patch.first_element + e];
    const ElementWorkspace<D> own = workspace.element(e);
    const Status status = assemble_patch_element<D>(batch, workspace, element, own, lanes);
    if (status != Status::ok) return mark_failed(batch, patch, status, lanes);
    for (int unknown = lanes.first(); unknown < tables.num_unknowns; unknown += lanes.count())
      own.solution[unknown] =
          batch.coefficients[static_cast<long>(element.result_slot) * tables.num_unknowns + unknown];
  }
  const AmplitudeSystem system = amplitude_system<D>(batch, patch, workspace, lanes);
  const double residual = evaluate_patch<D>(batch, patch, workspace, system, lanes);
  const Status status = residual <= residual_tolerance ? Status::ok : Status::residual_too_large;
  for (int e = 0; e < patch.num_elements; ++e) {
    const ElementWorkspace<D> own = workspace.element(e);
    post_process<D>(batch, tables, patch.first_element + e, *own.op, own.solution, own.inflow_data,
                    workspace.residual_scratch(), residual, status, 0, lanes);
  }
}

}  // namespace tentpole
