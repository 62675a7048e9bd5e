#pragma once

#include "kernels/element_residual.hpp"

namespace tentpole {

inline const double* body_force_block(const PatchBatch& batch, const ElementDescriptor& element) {
  return element.body_force_data == none ? nullptr : batch.prescribed + element.body_force_data;
}

/// Traces on the facet with this code: velocity and strain modes (stride facet_stride) into scratch.trace.
template <int D, class Lanes>
inline void facet_trace(const ReferenceTablesView& tables, int code, const double* inverse_jacobian,
                        const double* coefficients, const ResidualScratch& scratch, const Lanes& lanes) {
  gradient_modes<D>(tables, tables.facet_derivative(code), coefficients, scratch.gradient, lanes);
  lanes.synchronize();
  velocity_and_strain<D>(inverse_jacobian, scratch.gradient, tables.facet_stride, scratch.trace, lanes);
  lanes.synchronize();
}

/// Data below one inflow facet in its own modes (layout of an initial data block): copied from the prescribed data, or
/// the trace of the source element. Facet corners of source and element agree one by one, so no change of modes is
/// needed.
template <int D, class Lanes>
inline void load_facet_data(const PatchBatch& batch, const ReferenceTablesView& tables,
                            const ElementDescriptor& element, int facet, double* scratch_memory, double* data,
                            const Lanes& lanes) {
  constexpr int d = D + 1, num_fields = D + num_symmetric(D);
  const int num_modes = tables.num_facet_modes, slot = element.source_slot[facet];
  if (slot == none) {
    for (int entry = lanes.first(); entry < num_fields * num_modes + D * d; entry += lanes.count())
      data[entry] = batch.prescribed[element.facet_data[facet] + entry];
    return;
  }
  const ResidualScratch scratch = ResidualScratch::at(scratch_memory, tables);
  const double* coefficients = batch.coefficients + static_cast<long>(slot) * tables.num_unknowns;
  const int code = element.source_facet[facet];
  facet_trace<D>(tables, code, batch.inverse_jacobians + static_cast<long>(slot) * d * d, coefficients, scratch, lanes);
  for (int entry = lanes.first(); entry < num_fields * num_modes; entry += lanes.count())
    data[entry] = scratch.trace[entry / num_modes * tables.facet_stride + entry % num_modes];
  const double* value = tables.facet_value(code);
  for (int entry = lanes.first(); entry < D * d; entry += lanes.count()) {
    double sum = 0;
    for (int a = 0; a < tables.num_basis; ++a)
      sum += coefficients[entry / d * tables.num_basis + a] * value[a * d + entry % d];
    data[num_fields * num_modes + entry] = sum;
  }
  lanes.synchronize();
}

/// The data of all inflow facets of an element, block by block.
template <int D, class Lanes>
inline void load_inflow_data(const PatchBatch& batch, const ReferenceTablesView& tables,
                             const ElementDescriptor& element, const ElementOperator<D>& op, double* scratch_memory,
                             double* data, const Lanes& lanes) {
  const int data_size = (D + num_symmetric(D)) * tables.num_facet_modes + D * (D + 1);
  for (int f = 0; f < op.num_inflow; ++f)
    load_facet_data<D>(batch, tables, element, op.inflow[f].facet, scratch_memory, data + f * data_size, lanes);
}

/// Outgoing amplitudes O^T c through one vertical facet, from traces.
template <int D, class Lanes>
inline void emit_through_vertical(const VerticalFacet<D>& facet, const ReferenceTablesView& tables,
                                  const double* coefficients, const ResidualScratch& scratch, double* slots,
                                  const Lanes& lanes) {
  constexpr int d = D + 1;
  const int stride = tables.facet_stride, num_modes = tables.num_facet_modes;
  gradient_modes<D>(tables, tables.facet_derivative(facet.facet), coefficients, scratch.gradient, lanes);
  lanes.synchronize();
  for (int m = lanes.first(); m < num_modes; m += lanes.count())
    for (int c = 0; c < D; ++c) {
      double wave = 0;
      for (int i = 0; i < D; ++i)
        for (int l = 0; l < d; ++l)
          wave += (facet.impedance[c] * facet.velocity[c][i][l] - facet.traction[c][i][l]) *
                  scratch.gradient[(i * d + l) * stride + m];
      slots[c * num_modes + m] = sqrt(facet.measure / (2 * facet.impedance[c])) * wave;
    }
  lanes.synchronize();
}

/// Outgoing waves through one inclined facet and the moments that its other side (`receiver`, or nullptr) takes.
template <int D, class Lanes>
inline void emit_through_inclined(const InclinedFacet<D>& facet, const RigidFacet<D>* receiver,
                                  const ReferenceTablesView& tables, const double* coefficients,
                                  const ResidualScratch& scratch, double* slots, const Lanes& lanes) {
  constexpr int d = D + 1, num_rigid = RigidFacet<D>::num_rigid;
  const int stride = tables.facet_stride, num_modes = tables.num_facet_modes;
  gradient_modes<D>(tables, tables.facet_derivative(facet.facet), coefficients, scratch.gradient, lanes);
  lanes.synchronize();
  for (int m = lanes.first(); m < num_modes; m += lanes.count())
    for (int c = 0; c < facet.num_waves; ++c) {
      double wave = 0;
      for (int i = 0; i < D; ++i)
        for (int l = 0; l < d; ++l) wave += facet.outgoing[c][i][l] * scratch.gradient[(i * d + l) * stride + m];
      slots[c * num_modes + m] = wave;
    }
  if (lanes.first() == 0) {
    double displacement[D * d];
    displacement_modes<D>(tables, facet.facet, coefficients, displacement);
    for (int r = 0; r < num_rigid; ++r)
      slots[facet.num_waves * num_modes + r] = receiver ? rigid_amount<D>(*receiver, r, displacement) : 0.0;
  }
  lanes.synchronize();
}

/// Outgoing amplitudes of every port of an element. receivers as for assemble_element.
template <int D, class Lanes>
inline void emitted_amplitudes(const ElementOperator<D>& op, const RigidFacet<D>* const* receivers,
                               const ReferenceTablesView& tables, const CondensedShape& shape,
                               const double* coefficients, double* scratch_memory, double* outgoing,
                               const Lanes& lanes) {
  const ResidualScratch scratch = ResidualScratch::at(scratch_memory, tables);
  for (int f = 0; f < op.num_vertical; ++f)
    if (op.vertical[f].port != none)
      emit_through_vertical<D>(op.vertical[f], tables, coefficients, scratch,
                               outgoing + op.vertical[f].port * shape.amplitudes_per_port, lanes);
  for (int f = 0; f < op.num_inclined; ++f)
    emit_through_inclined<D>(op.inclined[f], receivers[f], tables, coefficients, scratch,
                             outgoing + op.inclined[f].port * shape.amplitudes_per_port, lanes);
}

/// Largest eigenvalue of a symmetric D x D tensor (closed forms; D = 3 by the trigonometric solution of the cubic).
template <int D>
inline double largest_principal(const double (&s)[D][D]) {
  if constexpr (D == 1) {
    return s[0][0];
  } else if constexpr (D == 2) {
    const double mean = 0.5 * (s[0][0] + s[1][1]), half = 0.5 * (s[0][0] - s[1][1]);
    return mean + sqrt(half * half + s[0][1] * s[0][1]);
  } else {
    const double mean = (s[0][0] + s[1][1] + s[2][2]) / 3;
    double deviator = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double value = s[i][j] - (i == j ? mean : 0);
        deviator += value * value;
      }
    const double p = sqrt(deviator / 6);
    if (!(p > 0)) return mean;
    const double a = (s[0][0] - mean) / p, b = (s[1][1] - mean) / p, c = (s[2][2] - mean) / p;
    const double x = s[0][1] / p, y = s[1][2] / p, z = s[0][2] / p;
    const double half_determinant = 0.5 * (a * (b * c - y * y) - x * (x * c - y * z) + z * (x * y - b * z));
    const double angle = acos(fmin(1.0, fmax(-1.0, half_determinant))) / 3;
    return mean + 2 * p * cos(angle);
  }
}

/// Largest principal stress at the corners of a facet whose trace is given.
template <int D>
inline double largest_corner_stress(const ElementOperator<D>& op, const ReferenceTablesView& tables,
                                    const double* trace) {
  const int stride = tables.facet_stride;
  double largest = 0;
  for (int corner = 0; corner <= D; ++corner) {
    double sigma[D][D] = {};
    for (int m = 0; m < tables.num_facet_modes; ++m)
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
          sigma[i][j] += tables.corner_psi[corner * stride + m] * stress<D>(op, trace + D * stride, stride, m, i, j);
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

/// Stores coefficients and J^-1 in the element store and completes the record.
template <int D, class Lanes>
inline void post_process(const PatchBatch& batch, const ReferenceTablesView& tables, int element_index,
                         const ElementOperator<D>& op, const double* solution, const double* inflow_data,
                         double* scratch_memory, double residual, Status status, int iterations, const Lanes& lanes) {
  constexpr int d = D + 1, num_fields = D + num_symmetric(D);
  const ElementDescriptor& element = batch.elements[element_index];
  const ResidualScratch scratch = ResidualScratch::at(scratch_memory, tables);
  for (int unknown = lanes.first(); unknown < tables.num_unknowns; unknown += lanes.count())
    batch.coefficients[static_cast<long>(element.result_slot) * tables.num_unknowns + unknown] = solution[unknown];
  for (int entry = lanes.first(); entry < d * d; entry += lanes.count())
    batch.inverse_jacobians[static_cast<long>(element.result_slot) * d * d + entry] =
        op.inverse_jacobian[entry / d][entry % d];
  const int stride = tables.facet_stride, num_modes = tables.num_facet_modes;
  double outflow_energy = 0, largest_stress = 0;
  for (int f = 0; f < op.num_outflow; ++f) {
    facet_trace<D>(tables, facet_table(element, D, op.outflow[f].facet), &op.inverse_jacobian[0][0], solution, scratch,
                   lanes);
    outflow_energy += facet_energy<D>(op, op.outflow[f].covector, scratch.trace, stride, num_modes);
    const double stress = largest_corner_stress<D>(op, tables, scratch.trace);
    largest_stress = f == 0 ? stress : fmax(largest_stress, stress);
    lanes.synchronize();
  }
  if (lanes.first() == 0) {
    ElementRecord& record = batch.records[element_index];
    record.outflow_energy = outflow_energy;
    record.max_principal_stress = largest_stress;
    record.inflow_energy = record.initial_energy = 0;
    for (int f = 0; f < op.num_inflow; ++f) {
      const double* data = inflow_data + f * (num_fields * num_modes + D * d);
      for (int field = 0; field < num_fields; ++field)
        for (int m = 0; m < num_modes; ++m) scratch.trace[field * stride + m] = data[field * num_modes + m];
      const double energy = -facet_energy<D>(op, op.inflow[f].covector, scratch.trace, stride, num_modes);
      record.inflow_energy += energy;
      if (element.source_slot[op.inflow[f].facet] == none) record.initial_energy += energy;
    }
    const double* body_force = body_force_block(batch, element);
    if (body_force) record.external_work += body_force_work<D>(op, tables, solution, body_force);
    record.residual = residual;
    record.status = static_cast<int>(status);
    record.num_iterations = iterations;
  }
  lanes.synchronize();
}

/// Empty records with a status for all elements and fracture facets of a patch.
template <class Lanes>
inline void mark_failed(const PatchBatch& batch, const PatchDescriptor& patch, Status status, const Lanes& lanes) {
  for (int e = lanes.first(); e < patch.num_elements; e += lanes.count()) {
    ElementRecord& record = batch.records[patch.first_element + e];
    record = ElementRecord{};
    record.status = static_cast<int>(status);
  }
  for (int f = lanes.first(); f < patch.num_fractures; f += lanes.count()) {
    FractureRecord& record = batch.fracture_records[patch.first_fracture + f];
    record = FractureRecord{};
    record.status = static_cast<int>(status);
  }
}

}  // namespace tentpole
