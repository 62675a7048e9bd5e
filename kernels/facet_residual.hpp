#pragma once

#include "kernels/facet_traces.hpp"
#include "kernels/facet_weights.hpp"

namespace tentpole {

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

}  // namespace tentpole
