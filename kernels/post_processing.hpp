#pragma once

#include "kernels/element_residual.hpp"

namespace tentpole {

inline const double* body_force_block(const PatchBatch& batch, const ElementDescriptor& element) {
  return element.body_force_data == none ? nullptr : batch.prescribed + element.body_force_data;
}

/// Traces on the outflow facet opposite `pole`: velocity and strain modes (stride facet_stride) into scratch.trace.
template <int D, class Lanes>
inline void outflow_trace(const ReferenceTablesView& tables, int pole, const double* inverse_jacobian,
                          const double* coefficients, const ResidualScratch& scratch, const Lanes& lanes) {
  const long size = (D + 1L) * tables.num_basis * tables.facet_stride;
  gradient_modes<D>(tables, tables.outflow_derivative + pole * size, coefficients, scratch.gradient, lanes);
  lanes.synchronize();
  velocity_and_strain<D>(inverse_jacobian, scratch.gradient, tables.facet_stride, scratch.trace, lanes);
  lanes.synchronize();
}

/// Data below the inflow facet in its own modes (layout of an initial data block): copied from the prescribed data, or
/// the trace of the source element. Facet corners of source and element agree one by one, so no change of modes is
/// needed.
template <int D, class Lanes>
inline void load_inflow_data(const PatchBatch& batch, const ReferenceTablesView& tables,
                             const ElementDescriptor& element, double* scratch_memory, double* data,
                             const Lanes& lanes) {
  constexpr int d = D + 1, num_fields = D + num_symmetric(D);
  const int num_modes = tables.num_facet_modes;
  if (element.source_slot == none) {
    for (int entry = lanes.first(); entry < num_fields * num_modes + D * d; entry += lanes.count())
      data[entry] = batch.prescribed[element.inflow_data + entry];
    return;
  }
  const ResidualScratch scratch = ResidualScratch::at(scratch_memory, tables);
  const double* coefficients = batch.coefficients + static_cast<long>(element.source_slot) * tables.num_unknowns;
  outflow_trace<D>(tables, element.source_pole,
                   batch.inverse_jacobians + static_cast<long>(element.source_slot) * d * d, coefficients, scratch,
                   lanes);
  for (int entry = lanes.first(); entry < num_fields * num_modes; entry += lanes.count())
    data[entry] = scratch.trace[entry / num_modes * tables.facet_stride + entry % num_modes];
  const double* value = tables.outflow_value + static_cast<long>(element.source_pole) * tables.num_basis * d;
  for (int entry = lanes.first(); entry < D * d; entry += lanes.count()) {
    double sum = 0;
    for (int a = 0; a < tables.num_basis; ++a)
      sum += coefficients[entry / d * tables.num_basis + a] * value[a * d + entry % d];
    data[num_fields * num_modes + entry] = sum;
  }
  lanes.synchronize();
}

/// Outgoing amplitudes O^T c of every port, from traces.
template <int D, class Lanes>
inline void emitted_amplitudes(const ElementOperator<D>& op, const ReferenceTablesView& tables,
                               const double* coefficients, double* scratch_memory, double* outgoing,
                               const Lanes& lanes) {
  constexpr int d = D + 1;
  const ResidualScratch scratch = ResidualScratch::at(scratch_memory, tables);
  const int stride = tables.facet_stride, num_modes = tables.num_facet_modes;
  for (int f = 0; f < op.num_vertical; ++f) {
    const VerticalFacet<D>& facet = op.vertical[f];
    if (facet.port == none) continue;
    const long size = static_cast<long>(d) * tables.num_basis * stride;
    gradient_modes<D>(tables, tables.vertical_derivative + facet.facet * size, coefficients, scratch.gradient, lanes);
    lanes.synchronize();
    for (int m = lanes.first(); m < num_modes; m += lanes.count())
      for (int c = 0; c < D; ++c) {
        double wave = 0;
        for (int i = 0; i < D; ++i)
          for (int l = 0; l < d; ++l)
            wave += (facet.impedance[c] * facet.velocity[c][i][l] - facet.traction[c][i][l]) *
                    scratch.gradient[(i * d + l) * stride + m];
        outgoing[facet.port * D * num_modes + c * num_modes + m] =
            sqrt(facet.measure / (2 * facet.impedance[c])) * wave;
      }
    lanes.synchronize();
  }
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

/// Largest principal stress at the corners of the outflow facet whose trace is given.
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
  outflow_trace<D>(tables, element.pole, &op.inverse_jacobian[0][0], solution, scratch, lanes);
  if (lanes.first() == 0) {
    ElementRecord& record = batch.records[element_index];
    record.outflow_energy =
        facet_energy<D>(op, op.outflow_covector, scratch.trace, tables.facet_stride, tables.num_facet_modes);
    record.max_principal_stress = largest_corner_stress<D>(op, tables, scratch.trace);
    for (int field = 0; field < num_fields; ++field)
      for (int m = 0; m < tables.num_facet_modes; ++m)
        scratch.trace[field * tables.facet_stride + m] = inflow_data[field * tables.num_facet_modes + m];
    record.inflow_energy =
        -facet_energy<D>(op, op.inflow_covector, scratch.trace, tables.facet_stride, tables.num_facet_modes);
    const double* body_force = body_force_block(batch, element);
    if (body_force) record.external_work += body_force_work<D>(op, tables, solution, body_force);
    record.residual = residual;
    record.status = static_cast<int>(status);
    record.num_iterations = iterations;
  }
  lanes.synchronize();
}

template <class Lanes>
inline void mark_failed(const PatchBatch& batch, const PatchDescriptor& patch, Status status, const Lanes& lanes) {
  for (int e = lanes.first(); e < patch.num_elements; e += lanes.count()) {
    ElementRecord& record = batch.records[patch.first_element + e];
    record = ElementRecord{};
    record.status = static_cast<int>(status);
  }
}

}  // namespace tentpole
