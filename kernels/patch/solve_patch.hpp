#pragma once

#include "kernels/coupling/eliminate.hpp"
#include "kernels/coupling/triangular_solve.hpp"
#include "kernels/element/larger_or_nan.hpp"
#include "kernels/formulation/one_field/emit_waves.hpp"
#include "kernels/formulation/one_field/post_processing.hpp"
#include "kernels/fracture/fracture_record.hpp"
#include "kernels/launch/cycle_counter.hpp"
#include "kernels/patch/connect_elements.hpp"
#include "kernels/patch/patch_assembly.hpp"

namespace tentpole {

/// One row of the transposition of an element's response block in place, after which products with it run along rows.
inline void transpose_response(const CondensedShape& shape, double* matrix, int row) {
  double* block = matrix + static_cast<long>(shape.unknowns_padded) * shape.stride + shape.unknowns_padded;
  for (int column = 0; column < row; ++column) {
    double& lower = block[static_cast<long>(row) * shape.stride + column];
    double& upper = block[static_cast<long>(column) * shape.stride + row];
    const double keep = lower;
    lower = upper;
    upper = keep;
  }
}

/// Eliminates the own unknowns of the elements of a range (kernels/coupling/eliminate.hpp); transposes their responses.
template <int D, class Lanes>
TENTPOLE_STEP void condense_elements(const PatchWorkspace<D>& workspace, ElementRange range, const Lanes& lanes) {
  const CondensedShape largest = workspace.largest_shape();
  const auto system_of = [&](int e) {
    const ElementWorkspace<D> own = workspace.element(e);
    return EliminatedSystem{own.matrix(), workspace.shape(own), own.inverse_upper(), own.is_regular()};
  };
  eliminate_elements(range, largest, system_of, workspace.packed(), lanes);
  share(lanes, range.count, largest.amplitudes_padded, [&](int e) {
    const ElementWorkspace<D> own = workspace.element(range.first + e);
    return [shape = workspace.shape(own), matrix = own.matrix()](int row) {
      if (row < shape.amplitudes_padded) transpose_response(shape, matrix, row);
    };
  });
  lanes.synchronize();
}

template <int D>
inline Status condensation_status(const PatchWorkspace<D>& workspace) {
  for (int e = 0; e < workspace.patch.num_elements; ++e)
    if (!*workspace.element(e).is_regular()) return Status::singular_pivot;
  return Status::ok;
}

/// What every element emits without incoming waves, t = O^T A^-1 b, from the eliminated right-hand sides, whose upper
/// part goes to `right`.
template <int D, class Lanes>
inline void take_condensed_sides(const PatchWorkspace<D>& workspace, const AmplitudeSystem& system,
                                 const Lanes& lanes) {
  share(lanes, system.num_elements, workspace.largest_shape().rows, [&](int e) {
    const ElementWorkspace<D> own = workspace.element(e);
    const CondensedShape shape = workspace.shape(own);
    const double* column = own.matrix() + shape.right_column();
    double *right = own.right(), *outgoing = workspace.outgoing() + system.offset(e);
    return [=](int row) {
      const int amplitude = row - shape.unknowns_padded;
      if (amplitude < 0)
        right[row] = column[static_cast<long>(row) * shape.stride];
      else if (amplitude < shape.num_amplitudes)
        outgoing[amplitude] = -column[static_cast<long>(row) * shape.stride];
    };
  });
  lanes.synchronize();
}

/// A matrix with the vector `right` for substitutions.
template <int D>
inline TriangularSystem triangular_system(const PatchWorkspace<D>& workspace, int e) {
  const ElementWorkspace<D> own = workspace.element(e);
  return {own.matrix(), workspace.shape(own).stride, own.right()};
}

/// The same for the residuals held in `right`: right = L^-1 right, t = (O^T U^-1) right.
template <int D, class Lanes>
TENTPOLE_STEP void condense_residuals(const PatchWorkspace<D>& workspace, const AmplitudeSystem& system,
                                      const Lanes& lanes) {
  const int n = workspace.largest_shape().unknowns_padded;
  for_each_range(lanes, system.num_elements, [&](ElementRange range) {
    forward_substitute(
        range, n, [&](int e) { return triangular_system<D>(workspace, e); }, lanes);
    share(lanes, range.count, system.max_amplitudes, [&](int e) {
      const ElementWorkspace<D> own = workspace.element(range.first + e);
      const CondensedShape shape = workspace.shape(own);
      double* outgoing = workspace.outgoing() + system.offset(range.first + e);
      return [=](int row) {
        if (row < shape.num_amplitudes)
          outgoing[row] = dot(own.matrix() + static_cast<long>(n + row) * shape.stride, own.right(), n);
      };
    });
  });
  lanes.synchronize();
}

/// solution += U^-1 (right + L^-1 P x) for all elements, x their incoming amplitudes.
template <int D, class Lanes>
TENTPOLE_STEP void recover_solutions(const PatchWorkspace<D>& workspace, const AmplitudeSystem& system,
                                     const Lanes& lanes) {
  const int n = workspace.largest_shape().unknowns_padded;
  for_each_range(lanes, system.num_elements, [&](ElementRange range) {
    share(lanes, range.count, n, [&](int e) {
      const ElementWorkspace<D> own = workspace.element(range.first + e);
      const CondensedShape shape = workspace.shape(own);
      const double* incoming = workspace.incoming() + system.offset(range.first + e);
      return [=](int row) {
        own.right()[row] +=
            dot(own.matrix() + static_cast<long>(row) * shape.stride + n, incoming, shape.num_amplitudes);
      };
    });
    lanes.synchronize();
    back_substitute(
        range, n, [&](int e) { return triangular_system<D>(workspace, e); }, lanes);
    share(lanes, range.count, n, [&](int e) {
      return [own = workspace.element(range.first + e)](int row) { own.solution()[row] += own.right()[row]; };
    });
  });
  lanes.synchronize();
}

/// Couples the elements for the waves t that they emit without any, and recovers their solutions. Patches with fracture
/// facets couple in rounds and leave their last maps in place.
template <int D, class Lanes>
inline DamageLoop couple_elements(const PatchBatch& batch, const PatchWorkspace<D>& workspace,
                                  const AmplitudeSystem& system, const Lanes& lanes) {
  DamageLoop loop;
  loop.has_converged = true;
  bool is_coupled = false;
  if constexpr (D < 3)
    if (workspace.patch.num_fractures > 0) {
      prepare_fractures<D>(batch, workspace, system, lanes);
      loop = solve_fractures<D>(batch, workspace, system, lanes);
      is_coupled = true;
    }
  if (!is_coupled)
    loop.iterations = solve_coupling(system, workspace.outgoing(), workspace.incoming(), workspace.coupling(), lanes);
  recover_solutions<D>(workspace, system, lanes);
  return loop;
}

/// Solves for the residuals held in `right` with the maps of the last solution. Returns the iterations of the coupling,
/// or -1.
template <int D, class Lanes>
inline int refine_solutions(const PatchWorkspace<D>& workspace, const AmplitudeSystem& system, const Lanes& lanes) {
  condense_residuals<D>(workspace, system, lanes);
  const int iterations =
      solve_coupling(system, workspace.outgoing(), workspace.incoming(), workspace.coupling(), lanes);
  recover_solutions<D>(workspace, system, lanes);
  return iterations;
}

/// Largest |r_i| / sqrt(A_ii) and the scale max(|c_i| sqrt(A_ii)).
struct ScaledNorms {
  double residual = 0;
  double solution = 0;

  void include(const ScaledNorms& other) {
    residual = larger_or_nan(residual, other.residual);
    solution = larger_or_nan(solution, other.solution);
  }
  /// Of a residual relative to the largest solution. Far below a wave's foot data may be denormal numbers, which have
  /// no relative accuracy to ask for.
  double relative_residual() const {
    constexpr double negligible = 1e-140;
    if (residual <= negligible && solution <= negligible) return 0.0;
    return solution > 0 ? residual / solution : 1.0;
  }
};

/// The norms over all unknowns of a patch; every lane gets them. `partial`: [2][lanes].
template <int D, class Lanes>
TENTPOLE_STEP ScaledNorms scaled_norms(const PatchWorkspace<D>& workspace, double* partial, const Lanes& lanes) {
  ScaledNorms norms;
  share(lanes, workspace.patch.num_elements, workspace.tables.num_unknowns, [&](int e) {
    return [&norms, own = workspace.element(e)](int unknown) {
      const double root = sqrt(own.diagonal()[unknown]);
      norms.include({fabs(own.right()[unknown]) / root, fabs(own.solution()[unknown]) * root});
    };
  });
  if constexpr (Lanes::cooperative) {
    partial[2 * lanes.first()] = norms.residual;
    partial[2 * lanes.first() + 1] = norms.solution;
    lanes.synchronize();
    for (int lane = 0; lane < lanes.count(); ++lane) norms.include({partial[2 * lane], partial[2 * lane + 1]});
    lanes.synchronize();
  }
  return norms;
}

/// Dissipation and work on the facets of element e.
template <int D>
inline void record_balance(const PatchBatch& batch, const PatchWorkspace<D>& workspace, int e) {
  const ElementWorkspace<D> own = workspace.element(e);
  ElementRecord& record = batch.records[workspace.patch.first_element + e];
  record.dissipation = record.external_work = 0;
  for (int f = 0; f < num_weighted_facets(own.op()); ++f) {
    record.dissipation += own.balance()[f].dissipation;
    record.external_work += own.balance()[f].external_work;
  }
}

/// Residuals of all elements with the amplitudes their neighbours really emit; fills the records. Returns the largest
/// residual relative to the largest solution of the patch (both diagonally scaled).
template <int D, class Lanes>
inline double evaluate_patch(const PatchBatch& batch, const PatchWorkspace<D>& workspace, const AmplitudeSystem& system,
                             const Lanes& lanes) {
  emit_solutions<D>(batch, workspace, system, lanes);
  exchange_amplitudes(system, all_places(system), workspace.outgoing(), workspace.incoming(), lanes);
  for_each_range(lanes, system.num_elements,
                 [&](ElementRange range) { element_residuals<D>(batch, workspace, range, &system, lanes); });
  share(lanes, system.num_elements, [&](int e) { record_balance<D>(batch, workspace, e); });
  return scaled_norms<D>(workspace, workspace.coupling().partial, lanes).relative_residual();
}

/// Assembles and condenses all elements of a patch. Returns the first status that is not ok.
template <int D, class Lanes>
inline Status condense_patch(const PatchBatch& batch, const PatchWorkspace<D>& workspace, StageCycles& cycles,
                             const Lanes& lanes) {
  const long long begun = cycle_counter();
  const Status status = build_operators<D>(batch, workspace, lanes);
  cycles.assembly += cycle_counter() - begun;
  if (status != Status::ok) return status;
  for_each_range(lanes, workspace.patch.num_elements, [&](ElementRange range) {
    const long long start = cycle_counter();
    assemble_elements<D>(batch, workspace, range, lanes);
    const long long assembled = cycle_counter();
    condense_elements<D>(workspace, range, lanes);
    cycles.assembly += assembled - start;
    cycles.solution += cycle_counter() - assembled;
  });
  return condensation_status<D>(workspace);
}

/// Solves one patch (docs/formulation.md, The patch solver): assemble and condense every element, couple the
/// amplitudes (in rounds with damage and contact where there are fracture facets), recover the coefficients, check the
/// residual, refine at most once, store coefficients and records.
template <int D, class Lanes>
inline void solve_patch(const PatchBatch& batch, const ReferenceTablesView& tables, int patch_index, double* scratch,
                        StageCycles& cycles, const Lanes& lanes) {
  constexpr double residual_tolerance = 1e-12;
  const PatchWorkspace<D> workspace(tables, batch.patches[patch_index], scratch, lanes);
  Status status = condense_patch<D>(batch, workspace, cycles, lanes);
  if (status != Status::ok) return mark_failed(batch, workspace.patch, status, lanes);
  const long long condensed = cycle_counter();
  const AmplitudeSystem system = connect_elements<D>(batch, workspace, lanes);
  take_condensed_sides<D>(workspace, system, lanes);
  const DamageLoop loop = couple_elements<D>(batch, workspace, system, lanes);
  if (!loop.has_converged) return mark_failed(batch, workspace.patch, Status::damage_not_converged, lanes);
  int iterations = loop.iterations;
  const long long solved = cycle_counter();
  cycles.solution += solved - condensed;
  double residual = evaluate_patch<D>(batch, workspace, system, lanes);
  if (!(residual <= residual_tolerance) || iterations < 0) {
    iterations = refine_solutions<D>(workspace, system, lanes);
    residual = evaluate_patch<D>(batch, workspace, system, lanes);
  }
  if (!(residual <= residual_tolerance))
    status = iterations < 0 ? Status::coupling_not_converged : Status::residual_too_large;
  if constexpr (D < 3) record_fractures<D>(batch, workspace, loop.rounds, status, lanes);
  post_process<D>(batch, workspace, {status, residual, iterations}, lanes);
  cycles.post_solution += cycle_counter() - solved;
}

/// Residuals, energies and records of a patch whose coefficients are in the element store (found by other means).
template <int D, class Lanes>
inline void check_patch(const PatchBatch& batch, const ReferenceTablesView& tables, int patch_index, double* scratch,
                        const Lanes& lanes) {
  constexpr double residual_tolerance = 1e-8;
  const PatchWorkspace<D> workspace(tables, batch.patches[patch_index], scratch, lanes);
  const PatchDescriptor& patch = workspace.patch;
  const Status built = build_operators<D>(batch, workspace, lanes);
  if (built != Status::ok) return mark_failed(batch, patch, built, lanes);
  for_each_range(lanes, patch.num_elements,
                 [&](ElementRange range) { assemble_elements<D>(batch, workspace, range, lanes); });
  share(lanes, patch.num_elements, tables.num_unknowns, [&](int e) {
    const long slot = batch.elements[patch.first_element + e].result_slot;
    const double* coefficients = batch.coefficients + slot * tables.num_unknowns;
    return [=, solution = workspace.element(e).solution()](int unknown) { solution[unknown] = coefficients[unknown]; };
  });
  lanes.synchronize();
  const AmplitudeSystem system = connect_elements<D>(batch, workspace, lanes);
  if constexpr (D < 3)
    if (patch.num_fractures > 0) {
      prepare_fractures<D>(batch, workspace, system, lanes);
      emit_solutions<D>(batch, workspace, system, lanes);
      integrate_fractures<D>(batch, workspace, workspace.outgoing(), lanes);
      accept_round<D>(batch.fracture_law, workspace, 0, false, lanes);
    }
  const double residual = evaluate_patch<D>(batch, workspace, system, lanes);
  const Status status = residual <= residual_tolerance ? Status::ok : Status::residual_too_large;
  if constexpr (D < 3) record_fractures<D>(batch, workspace, 0, status, lanes);
  post_process<D>(batch, workspace, {status, residual, 0}, lanes);
}

}  // namespace tentpole
