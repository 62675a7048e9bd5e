#pragma once

#include "kernels/element_matrix.hpp"

namespace tentpole {

/// Traces on one facet in its modes: velocity [i][m], strain (xx, yy, zz, xy, yz, xz) [s][m], stride facet_stride.
/// Gradient modes G[i][l][m] = sum_a c[i, a] <d_l phi_a psi_m> go first; no coefficients mean zero.
template <int D, class Lanes>
inline void gradient_modes(const ReferenceTablesView& tables, const double* derivative, const double* coefficients,
                           double* gradient, const Lanes& lanes) {
  constexpr int d = D + 1;
  const int num_basis = tables.num_basis, stride = tables.facet_stride;
  for (int block = lanes.first(); block < D * d * (stride / 4); block += lanes.count()) {
    const int i = block / (d * (stride / 4)), l = block / (stride / 4) % d, m = block % (stride / 4) * 4;
    Vector4 sum{};
    const double* table = derivative + static_cast<long>(l) * num_basis * stride + m;
    if (coefficients)
      for (int a = 0; a < num_basis; ++a)
        sum += coefficients[i * num_basis + a] * load4(table + static_cast<long>(a) * stride);
    store4(gradient + (i * d + l) * stride + m, sum);
  }
}

/// residual[(i, a)] += sum_l sum_m <d_l phi_a psi_m> flux[l][i][m]: tests mode fluxes of one facet.
template <int D, class Lanes>
inline void test_facet(const ReferenceTablesView& tables, const double* derivative, const double* flux,
                       double* residual, const Lanes& lanes) {
  constexpr int d = D + 1;
  const int num_basis = tables.num_basis, stride = tables.facet_stride;
  for (int a = lanes.first(); a < num_basis; a += lanes.count()) {
    Vector4 sum[D] = {};
    for (int l = 0; l < d; ++l) {
      const double* table = derivative + (static_cast<long>(l) * num_basis + a) * stride;
      for (int m = 0; m < stride; m += 4) {
        const Vector4 modes = load4(table + m);
        for (int i = 0; i < D; ++i) sum[i] += modes * load4(flux + (l * D + i) * stride + m);
      }
    }
    for (int i = 0; i < D; ++i) residual[i * num_basis + a] += (sum[i][0] + sum[i][1]) + (sum[i][2] + sum[i][3]);
  }
}

/// Velocity and strain modes from gradient modes and J^-1 (row-major [l][j], stride d).
template <int D, class Lanes>
inline void velocity_and_strain(const double* inverse_jacobian, const double* gradient, int stride, double* trace,
                                const Lanes& lanes) {
  constexpr int d = D + 1;
  for (int m = lanes.first() * 4; m < stride; m += lanes.count() * 4) {
    Vector4 physical[D][d];
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < d; ++j) {
        Vector4 sum{};
        for (int l = 0; l < d; ++l) sum += inverse_jacobian[l * d + j] * load4(gradient + (i * d + l) * stride + m);
        physical[i][j] = sum;
      }
    for (int i = 0; i < D; ++i) {
      store4(trace + i * stride + m, physical[i][D]);
      for (int j = i; j < D; ++j)
        store4(trace + (D + symmetric_index(D, i, j)) * stride + m, 0.5 * (physical[i][j] + physical[j][i]));
    }
  }
}

/// sigma_ij at one mode from strain modes.
template <int D>
inline double stress(const ElementOperator<D>& op, const double* strain, int stride, int m, int i, int j) {
  double value = 2 * op.mu * strain[symmetric_index(D, i, j) * stride + m];
  if (i == j)
    for (int p = 0; p < D; ++p) value += op.lambda * strain[p * stride + m];
  return value;
}

/// int 1/2 w^T A_N w over a facet with covector N dA: N_t (rho v.v + E:C:E)/2 - v.(sigma N_x). Uniform in the modes.
template <int D>
inline double facet_energy(const ElementOperator<D>& op, const double* covector, const double* trace, int stride,
                           int num_modes) {
  double energy = 0;
  const double* strain = trace + D * stride;
  for (int m = 0; m < num_modes; ++m) {
    double kinetic = 0, elastic = 0, power = 0;
    for (int i = 0; i < D; ++i) {
      const double velocity = trace[i * stride + m];
      kinetic += velocity * velocity;
      for (int j = 0; j < D; ++j) {
        const double sigma = stress<D>(op, strain, stride, m, i, j);
        elastic += sigma * strain[symmetric_index(D, i, j) * stride + m];
        power += velocity * sigma * covector[j];
      }
    }
    energy += 0.5 * covector[D] * (op.density * kinetic + elastic) - power;
  }
  return energy;
}

/// Flux of -A_N j, j the jump (external - internal) of (v, E) on an inflow facet: flux[l][i][m].
template <int D, class Lanes>
inline void inflow_flux(const ElementOperator<D>& op, const FrontFacet<D>& facet, const double* jump, int stride,
                        double* flux, const Lanes& lanes) {
  constexpr int d = D + 1;
  const double* normal = facet.covector;
  const double minus_time = -normal[D];
  for (int m = lanes.first(); m < stride; m += lanes.count()) {
    double sigma[D][D], traction[D], velocity[D], velocity_normal = 0;
    for (int i = 0; i < D; ++i) {
      velocity[i] = jump[i * stride + m];
      velocity_normal += velocity[i] * normal[i];
      traction[i] = 0;
      for (int j = 0; j < D; ++j) {
        sigma[i][j] = stress<D>(op, jump + D * stride, stride, m, i, j);
        traction[i] += sigma[i][j] * normal[j];
      }
    }
    for (int l = 0; l < d; ++l) {
      const double* g = op.inverse_jacobian[l];
      double g_normal = 0, g_velocity = 0;
      for (int j = 0; j < D; ++j) g_normal += g[j] * normal[j], g_velocity += g[j] * velocity[j];
      for (int i = 0; i < D; ++i) {
        double value = g[D] * (minus_time * op.density * velocity[i] + traction[i]) +
                       op.lambda * g[i] * velocity_normal + op.mu * (g_normal * velocity[i] + g_velocity * normal[i]);
        for (int p = 0; p < D; ++p) value += minus_time * sigma[i][p] * g[p];
        flux[(l * D + i) * stride + m] = value;
      }
    }
  }
}

/// What one evaluation of the element's equations also yields.
struct ElementBalance {
  double dissipation = 0;
  double external_work = 0;
};

/// Jump s* - s of one component in modes on a vertical facet; `trace` holds v_c at [c], s_c at [D + c] (frame
/// components, own normal). incoming: amplitudes of this facet [c][m] (interior), value: prescribed block [i][m] or
/// nullptr (boundary).
template <int D>
inline double target_jump(const VerticalFacet<D>& facet, int c, double velocity, double traction, double incoming,
                          double value) {
  double test_velocity, test_traction, trial_velocity, trial_traction;
  facet_factors<D>(facet, c, test_velocity, test_traction, trial_velocity, trial_traction);
  double data = value;
  if (facet.port != none) {
    const double outer = facet.outer_impedance[c];
    data = trial_traction * sqrt(2 * outer / facet.measure) * incoming;
  } else if (facet.kind[c] == BoundaryKind::velocity) {
    data = facet.impedance[c] * value;
  } else if (facet.kind[c] == BoundaryKind::absorbing) {
    data = 0.5 * value;
  }
  return data - trial_velocity * velocity - trial_traction * traction;
}

/// Prescribed frame component of a boundary block at one mode, 0 without data.
template <int D>
inline double prescribed_component(const VerticalFacet<D>& facet, const double* prescribed, int num_modes, int c,
                                   int m) {
  if (facet.port != none || facet.boundary_data == none) return 0;
  double value = 0;
  for (int i = 0; i < D; ++i) value += facet.frame[c][i] * prescribed[facet.boundary_data + i * num_modes + m];
  return value;
}

/// Scratch of the residual: gradient modes, trace, jump, flux of one facet, and curvature modes
/// [D][num_curvature_modes].
struct ResidualScratch {
  double* gradient;
  double* trace;
  double* flux;
  double* curvature;
  static long size(const ReferenceTablesView& tables) {
    const int dimension = tables.dimension, d = dimension + 1;
    return static_cast<long>(tables.facet_stride) * (2 * dimension * d + dimension + num_symmetric(dimension)) +
           (dimension * tables.num_volume_modes + 3) / 4 * 4;
  }
  static ResidualScratch at(double* scratch, const ReferenceTablesView& tables) {
    const int dimension = tables.dimension, d = dimension + 1;
    ResidualScratch parts;
    parts.gradient = scratch;
    parts.flux = parts.gradient + dimension * d * tables.facet_stride;
    parts.trace = parts.flux + dimension * d * tables.facet_stride;
    parts.curvature = parts.trace + (dimension + num_symmetric(dimension)) * tables.facet_stride;
    return parts;
  }
};

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

/// residual += -A_N (w_ext - w) over one inflow facet. `data`: velocity, strain modes then displacement [D][D + 1]
/// (layout of an initial data block, stride num_facet_modes).
template <int D, class Lanes>
inline void inflow_residual(const ElementOperator<D>& op, const FrontFacet<D>& facet, const ReferenceTablesView& tables,
                            const double* coefficients, const double* data, const ResidualScratch& scratch,
                            double* residual, ElementBalance& balance, const Lanes& lanes) {
  constexpr int num_fields = D + num_symmetric(D);
  const int stride = tables.facet_stride, num_modes = tables.num_facet_modes;
  const double* derivative = tables.facet_derivative(facet.facet);
  gradient_modes<D>(tables, derivative, coefficients, scratch.gradient, lanes);
  lanes.synchronize();
  velocity_and_strain<D>(&op.inverse_jacobian[0][0], scratch.gradient, stride, scratch.trace, lanes);
  lanes.synchronize();
  for (int entry = lanes.first(); entry < num_fields * stride; entry += lanes.count()) {
    const int field = entry / stride, m = entry % stride;
    scratch.trace[entry] = (m < num_modes ? data[field * num_modes + m] : 0) - scratch.trace[entry];
  }
  lanes.synchronize();
  balance.dissipation += -facet_energy<D>(op, facet.covector, scratch.trace, stride, num_modes);
  inflow_flux<D>(op, facet, scratch.trace, stride, scratch.flux, lanes);
  lanes.synchronize();
  test_facet<D>(tables, derivative, scratch.flux, residual, lanes);
  lanes.synchronize();
}

/// int_f |N_t| R_r . u over one facet with N_t < 0, with the displacement modes [D][D + 1] of u there.
template <int D>
inline double rigid_amount(const RigidFacet<D>& rigid, int r, const double* displacement) {
  double amount = 0;
  for (int i = 0; i < D; ++i)
    for (int m = 0; m <= D; ++m) amount += rigid.modes[r][i][m] * displacement[i * (D + 1) + m];
  return rigid.root * amount;
}

/// Displacement modes [D][D + 1] of the coefficients on the facet with this code.
template <int D>
inline void displacement_modes(const ReferenceTablesView& tables, int code, const double* coefficients,
                               double* displacement) {
  const double* value = tables.facet_value(code);
  for (int i = 0; i < D; ++i)
    for (int m = 0; m <= D; ++m) {
      double sum = 0;
      for (int a = 0; a < tables.num_basis; ++a) sum += coefficients[i * tables.num_basis + a] * value[a * (D + 1) + m];
      displacement[i * (D + 1) + m] = sum;
    }
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

/// residual += sum over incoming waves of wave(what) (amplitude - wave(w)) over one inclined facet.
template <int D, class Lanes>
inline void inclined_residual(const InclinedFacet<D>& facet, const ReferenceTablesView& tables,
                              const double* coefficients, const double* incoming, const ResidualScratch& scratch,
                              double* residual, ElementBalance& balance, const Lanes& lanes) {
  constexpr int d = D + 1;
  const int stride = tables.facet_stride, num_modes = tables.num_facet_modes;
  const double* derivative = tables.facet_derivative(facet.facet);
  gradient_modes<D>(tables, derivative, coefficients, scratch.gradient, lanes);
  lanes.synchronize();
  for (int m = lanes.first(); m < stride; m += lanes.count()) {
    for (int entry = 0; entry < d * D; ++entry) scratch.flux[entry * stride + m] = 0;
    for (int c = 0; c < facet.num_waves && m < num_modes; ++c) {
      double jump = incoming ? incoming[c * num_modes + m] : 0;
      for (int i = 0; i < D; ++i)
        for (int l = 0; l < d; ++l) jump -= facet.incoming[c][i][l] * scratch.gradient[(i * d + l) * stride + m];
      for (int i = 0; i < D; ++i)
        for (int l = 0; l < d; ++l) scratch.flux[(l * D + i) * stride + m] += facet.incoming[c][i][l] * jump;
      scratch.trace[c * stride + m] = jump;
    }
  }
  lanes.synchronize();
  for (int c = 0; c < facet.num_waves; ++c)
    for (int m = 0; m < num_modes; ++m)
      balance.dissipation += 0.5 * scratch.trace[c * stride + m] * scratch.trace[c * stride + m];
  test_facet<D>(tables, derivative, scratch.flux, residual, lanes);
  lanes.synchronize();
}

/// residual += int (vhat + shat/Z).(s* - s) over one vertical facet.
template <int D, class Lanes>
inline void vertical_residual(const VerticalFacet<D>& facet, const ReferenceTablesView& tables,
                              const double* coefficients, const double* incoming, const double* prescribed,
                              const ResidualScratch& scratch, double* residual, ElementBalance& balance,
                              const Lanes& lanes) {
  constexpr int d = D + 1;
  const int stride = tables.facet_stride, num_modes = tables.num_facet_modes;
  const double* derivative = tables.facet_derivative(facet.facet);
  gradient_modes<D>(tables, derivative, coefficients, scratch.gradient, lanes);
  lanes.synchronize();
  for (int m = lanes.first(); m < stride; m += lanes.count()) {
    for (int entry = 0; entry < d * D; ++entry) scratch.flux[entry * stride + m] = 0;
    if (m >= num_modes) continue;
    for (int c = 0; c < D; ++c) {
      double velocity = 0, traction = 0;
      for (int i = 0; i < D; ++i)
        for (int l = 0; l < d; ++l) {
          const double gradient = scratch.gradient[(i * d + l) * stride + m];
          velocity += facet.velocity[c][i][l] * gradient;
          traction += facet.traction[c][i][l] * gradient;
        }
      const double wave = facet.port != none && incoming ? incoming[c * num_modes + m] : 0;
      const double jump = target_jump<D>(facet, c, velocity, traction, wave,
                                         prescribed_component<D>(facet, prescribed, num_modes, c, m));
      for (int i = 0; i < D; ++i)
        for (int l = 0; l < d; ++l)
          scratch.flux[(l * D + i) * stride + m] +=
              facet.measure * jump * (facet.velocity[c][i][l] + facet.traction[c][i][l] / facet.impedance[c]);
      scratch.trace[c * stride + m] = jump;
      scratch.trace[(D + c) * stride + m] = (velocity + jump / facet.impedance[c]) * (traction + jump);
    }
  }
  lanes.synchronize();
  for (int c = 0; c < D; ++c)
    for (int m = 0; m < num_modes; ++m) {
      const double jump = scratch.trace[c * stride + m];
      balance.dissipation += facet.measure * jump * jump / facet.impedance[c];
      if (facet.port == none) balance.external_work += facet.measure * scratch.trace[(D + c) * stride + m];
    }
  test_facet<D>(tables, derivative, scratch.flux, residual, lanes);
  lanes.synchronize();
}

/// residual = b + P x - A c of one element, matrix-free from the weak form, with its dissipation and boundary work.
/// Without coefficients and incoming amplitudes (nullptr) it is the right-hand side b. inflow_data: one block per
/// inflow facet of the operator. All lanes get the same balance.
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
  for (int f = 0; f < op.num_inclined; ++f)
    inclined_residual<D>(op.inclined[f], tables, coefficients,
                         incoming ? incoming + op.inclined[f].port * shape.amplitudes_per_port : nullptr, scratch,
                         residual, balance, lanes);
  for (int f = 0; f < op.num_vertical; ++f) {
    const double* amplitudes =
        incoming && op.vertical[f].port != none ? incoming + op.vertical[f].port * shape.amplitudes_per_port : nullptr;
    vertical_residual<D>(op.vertical[f], tables, coefficients, amplitudes, prescribed, scratch, residual, balance,
                         lanes);
  }
  return balance;
}

}  // namespace tentpole
