#pragma once

#include "kernels/element_matrix.hpp"
#include "kernels/facet_residual.hpp"

namespace tentpole {

/// residual += volume part: rho b - (rho v_t - div sigma) tested with vhat.
template <int D, class Lanes>
inline void volume_residual(const ElementOperator<D>& op, const ReferenceTablesView& tables, const double* coefficients,
                            const double* body_force, const ResidualScratch& scratch, double* residual,
                            const Lanes& lanes) {
  constexpr int d = D + 1;
  const int num_basis = tables.num_basis, stride = tables.basis_stride, num_modes = tables.num_volume_modes;
  if (!coefficients && !body_force) return;
  for (int q = lanes.first(); q < num_modes; q += lanes.count())
    for (int i = 0; i < D; ++i)
      scratch.curvature[i * num_modes + q] = body_force ? op.determinant * body_force[i * num_modes + q] : 0;
  for (int q = lanes.first(); coefficients && q < tables.num_curvature_modes; q += lanes.count())
    for (int l = 0, pair = 0; l < d; ++l)
      for (int k = l; k < d; ++k, ++pair) {
        const double* table = tables.curvature + (static_cast<long>(pair) * tables.num_curvature_modes + q) * stride;
        for (int j = 0; j < D; ++j) {
          const double second = op.determinant * dot(table, coefficients + j * num_basis, num_basis);
          for (int i = 0; i < D; ++i) scratch.curvature[i * num_modes + q] -= volume_weight<D>(op, i, j, l, k) * second;
        }
      }
  lanes.synchronize();
  const int used = body_force ? num_modes : tables.num_curvature_modes;
  for (int a = lanes.first(); a < num_basis; a += lanes.count())
    for (int l = 0; l < d; ++l) {
      const double* table = tables.volume_derivative + static_cast<long>(l * num_basis + a) * num_modes;
      for (int i = 0; i < D; ++i)
        residual[i * num_basis + a] += op.time_slope(l) * dot(table, scratch.curvature + i * num_modes, used);
    }
  lanes.synchronize();
}

/// residual += kappa int uhat_0 . (u_ext - u) |N_t| over all facets with N_t < 0: what comes from below or, as
/// amplitudes, through inclined facets, minus the own rigid motion.
template <int D, class Lanes>
inline void rigid_residual(const ElementOperator<D>& op, const ReferenceTablesView& tables, const CondensedShape& shape,
                           const double* coefficients, const double* incoming, const double* inflow_data,
                           double* residual, const Lanes& lanes) {
  constexpr int d = D + 1, num_fields = D + num_symmetric(D), num_rigid = ElementOperator<D>::num_rigid;
  const int num_modes = tables.num_facet_modes, data_size = num_fields * num_modes + D * d;
  double amount[num_rigid] = {};
  for (int f = 0; f < op.num_rigid_facets && coefficients; ++f) {
    double displacement[D * d];
    displacement_modes<D>(tables, op.rigid[f].facet, coefficients, displacement);
    for (int r = 0; r < num_rigid; ++r) amount[r] -= rigid_amount<D>(op.rigid[f], r, displacement);
  }
  for (int f = 0; f < op.num_inflow; ++f)
    for (int r = 0; r < num_rigid; ++r)
      amount[r] += rigid_amount<D>(op.rigid[f], r, inflow_data + f * data_size + num_fields * num_modes);
  for (int f = 0; f < op.num_inclined && incoming; ++f)
    if (op.inclined[f].rigid != none) {
      const double* slots = incoming + op.inclined[f].port * shape.amplitudes_per_port;
      for (int r = 0; r < num_rigid; ++r) amount[r] += slots[op.inclined[f].num_waves * num_modes + r];
    }
  for (int f = 0; f < op.num_rigid_facets; ++f) {
    const RigidFacet<D>& rigid = op.rigid[f];
    const double* value = tables.facet_value(rigid.facet);
    double motion[D][d] = {};  // |N_t| sum_r amount_r R_r in chi modes
    for (int r = 0; r < num_rigid; ++r)
      for (int i = 0; i < D; ++i)
        for (int m = 0; m < d; ++m) motion[i][m] += rigid.root * amount[r] * rigid.modes[r][i][m];
    for (int a = lanes.first(); a < tables.num_basis; a += lanes.count())
      for (int i = 0; i < D; ++i) {
        double sum = 0;
        for (int m = 0; m < d; ++m) sum += motion[i][m] * value[a * d + m];
        residual[i * tables.num_basis + a] += sum;
      }
  }
  lanes.synchronize();
}

/// residual = b + P x - A c of one element, matrix-free from the weak form, with its dissipation and boundary work.
/// Without coefficients and incoming amplitudes (nullptr) it is the right-hand side b, to which facets inside the patch
/// add nothing. inflow_data: one block per inflow facet of the operator. All lanes get the same balance.
template <int D, class Lanes>
inline ElementBalance element_residual(const ElementOperator<D>& op, const ReferenceTablesView& tables,
                                       const CondensedShape& shape, const double* coefficients, const double* incoming,
                                       const double* inflow_data, const double* body_force, const double* prescribed,
                                       double* scratch_memory, double* residual, const Lanes& lanes) {
  const ResidualScratch scratch = ResidualScratch::at(scratch_memory, tables);
  ElementBalance balance;
  for (int unknown = lanes.first(); unknown < shape.unknowns_padded; unknown += lanes.count()) residual[unknown] = 0;
  lanes.synchronize();
  volume_residual<D>(op, tables, coefficients, body_force, scratch, residual, lanes);
  const int data_size = (D + num_symmetric(D)) * tables.num_facet_modes + D * (D + 1);
  for (int f = 0; f < op.num_inflow; ++f)
    inflow_residual<D>(op, op.inflow[f], tables, coefficients, inflow_data + f * data_size, scratch, residual, balance,
                       lanes);
  rigid_residual<D>(op, tables, shape, coefficients, incoming, inflow_data, residual, lanes);
  for (int f = 0; f < op.num_inclined && coefficients; ++f)
    inclined_residual<D>(op.inclined[f], tables, coefficients,
                         incoming ? incoming + op.inclined[f].port * shape.amplitudes_per_port : nullptr, scratch,
                         residual, balance, lanes);
  for (int f = 0; f < op.num_vertical; ++f) {
    if (!coefficients && op.vertical[f].port != none) continue;
    const double* amplitudes =
        incoming && op.vertical[f].port != none ? incoming + op.vertical[f].port * shape.amplitudes_per_port : nullptr;
    vertical_residual<D>(op.vertical[f], tables, coefficients, amplitudes, prescribed, scratch, residual, balance,
                         lanes);
  }
  return balance;
}

}  // namespace tentpole
