#pragma once

#include "kernels/element/principal_stress.hpp"
#include "kernels/formulation/one_field/element_residual.hpp"

namespace tentpole {

/// Largest principal stress at the corners of a facet whose trace is given.
template <int D>
inline double largest_corner_stress(const ElementOperator<D>& op, const ReferenceTablesView& tables,
                                    const double* trace) {
  const int stride = tables.facet_stride;
  double largest = 0;
  for (int corner = 0; corner <= D; ++corner) {
    double sigma[D][D] = {};
    for (int m = 0; m < tables.num_facet_modes; ++m) {
      double strain[num_symmetric(D)];
      load_strain<D>(trace, stride, m, strain);
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) sigma[i][j] += tables.corner_psi[corner * stride + m] * stress<D>(op, strain, i, j);
    }
    const double principal = largest_principal<D>(sigma);
    largest = corner == 0 ? principal : fmax(largest, principal);
  }
  return largest;
}

/// int v.(rho b) over the element.
template <int D>
inline double body_force_work(const ElementOperator<D>& op, const ReferenceTablesView& tables,
                              const double* coefficients, const double* body_force) {
  double work = 0;
  for (int i = 0; i < D; ++i)
    for (int l = 0; l <= D; ++l)
      for (int a = 0; a < tables.num_basis; ++a)
        work += op.time_slope(l) * coefficients[i * tables.num_basis + a] *
                dot(tables.volume_derivative + (static_cast<long>(l) * tables.num_basis + a) * tables.num_volume_modes,
                    body_force + i * tables.num_volume_modes, tables.num_volume_modes);
  return op.determinant * work;
}

/// Four modes of the trace of the solution on one outflow facet.
template <int D>
inline void outflow_trace(const PatchWorkspace<D>& workspace, const ElementWorkspace<D>& own, int facet, int m) {
  constexpr int num_fields = D + num_symmetric(D);
  const int stride = workspace.tables.facet_stride;
  Vector4 trace[num_fields];
  velocity_and_strain<D>(&own.op().inverse_jacobian[0][0], own.gradient(facet), stride, m, trace);
  for (int field = 0; field < num_fields; ++field) store4(own.trace(facet) + field * stride + m, trace[field]);
}

/// Energy through inflow facet f, or through outflow facet f - num_inflow and the stress there.
template <int D>
inline void measure_front_facet(const PatchWorkspace<D>& workspace, const ElementWorkspace<D>& own, int f) {
  const ReferenceTablesView& tables = workspace.tables;
  const ElementOperator<D>& op = own.op();
  const int num_modes = tables.num_facet_modes, outflow = f - op.num_inflow;
  FrontFacetRecord& record = own.front()[f];
  if (outflow < 0) {
    record.energy = -facet_energy<D>(op, op.inflow[f].covector, own.inflow_data() + f * workspace.inflow_block(),
                                     num_modes, num_modes);
  } else if (outflow < op.num_outflow) {
    const double* trace = own.trace(op.outflow[outflow].facet);
    record.energy = facet_energy<D>(op, op.outflow[outflow].covector, trace, tables.facet_stride, num_modes);
    record.principal_stress = largest_corner_stress<D>(op, tables, trace);
  }
}

/// How the solution of a patch ended.
struct PatchOutcome {
  Status status;
  double residual;
  int iterations;
};

/// Completes the record of element e, whose dissipation and work on its facets are there.
template <int D>
inline void record_element(const PatchBatch& batch, const PatchWorkspace<D>& workspace, const PatchOutcome& outcome,
                           int e) {
  const ElementDescriptor& element = batch.elements[workspace.patch.first_element + e];
  ElementRecord& record = batch.records[workspace.patch.first_element + e];
  const ElementWorkspace<D> own = workspace.element(e);
  const ElementOperator<D>& op = own.op();
  record.inflow_energy = record.initial_energy = record.outflow_energy = record.max_principal_stress = 0;
  for (int f = 0; f < op.num_inflow; ++f) {
    const double energy = own.front()[f].energy;
    record.inflow_energy += energy;
    if (element.source_slot[op.inflow[f].facet] == none) record.initial_energy += energy;
  }
  for (int f = 0; f < op.num_outflow; ++f) {
    const FrontFacetRecord& facet = own.front()[op.num_inflow + f];
    record.outflow_energy += facet.energy;
    record.max_principal_stress =
        f == 0 ? facet.principal_stress : fmax(record.max_principal_stress, facet.principal_stress);
  }
  const double* body_force = body_force_block(batch, element);
  if (body_force) record.external_work += body_force_work<D>(op, workspace.tables, own.solution(), body_force);
  record.residual = outcome.residual;
  record.status = static_cast<int>(outcome.status);
  record.num_iterations = outcome.iterations;
}

/// Stores coefficients and J^-1 of all elements in the element store and completes their records.
template <int D, class Lanes>
TENTPOLE_STEP void post_process(const PatchBatch& batch, const PatchWorkspace<D>& workspace,
                                const PatchOutcome& outcome, const Lanes& lanes) {
  constexpr int d = D + 1, num_facets = D + 2;
  const ReferenceTablesView& tables = workspace.tables;
  for_each_range(lanes, workspace.patch.num_elements, [&](ElementRange range) {
    const auto slot_of = [&](int e) -> long {
      return batch.elements[workspace.patch.first_element + range.first + e].result_slot;
    };
    share(lanes, range.count, tables.num_unknowns, [&](int e) {
      double* coefficients = batch.coefficients + slot_of(e) * tables.num_unknowns;
      return [=, solution = workspace.element(range.first + e).solution()](int unknown) {
        coefficients[unknown] = solution[unknown];
      };
    });
    share(lanes, range.count, d * d, [&](int e) {
      double* inverse_jacobian = batch.inverse_jacobians + slot_of(e) * d * d;
      return [=, &op = workspace.element(range.first + e).op()](int entry) {
        inverse_jacobian[entry] = op.inverse_jacobian[entry / d][entry % d];
      };
    });
    share(lanes, range.count, num_facets * num_mode_blocks(tables), [&](int e) {
      return [&, own = workspace.element(range.first + e)](int item) {
        const int f = item % num_facets;
        if (f < own.op().num_outflow)
          outflow_trace<D>(workspace, own, own.op().outflow[f].facet, 4 * (item / num_facets));
      };
    });
    lanes.synchronize();
    share(lanes, range.count, num_facets, [&](int e) {
      return [&, own = workspace.element(range.first + e)](int f) { measure_front_facet<D>(workspace, own, f); };
    });
    lanes.synchronize();
    share(lanes, range.count, [&](int e) { record_element<D>(batch, workspace, outcome, range.first + e); });
    lanes.synchronize();
  });
}

/// Empty records with a status for all elements and fracture facets of a patch.
template <class Lanes>
inline void mark_failed(const PatchBatch& batch, const PatchDescriptor& patch, Status status, const Lanes& lanes) {
  share(lanes, patch.num_elements, [&](int e) {
    ElementRecord& record = batch.records[patch.first_element + e];
    record = ElementRecord{};
    record.status = static_cast<int>(status);
  });
  share(lanes, patch.num_fractures, [&](int f) {
    FractureRecord& record = batch.fracture_records[patch.first_fracture + f];
    record = FractureRecord{};
    record.status = static_cast<int>(status);
  });
}

}  // namespace tentpole
