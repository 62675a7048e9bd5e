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

/// Data of one component in four modes from m on, with which the jump of a vertical facet is
///   s* - s = data - trial(own)
/// (facet_weights.hpp). incoming: amplitudes of this facet [c][m] (interior); prescribed: blocks [i][m] or nullptr
/// (boundary); both count as zero where they are missing and beyond num_modes.
template <int D>
inline Vector4 target_data(const VerticalFacet<D>& facet, double trial_traction, const double* incoming,
                           const double* prescribed, int num_modes, int c, int m) {
  Vector4 data{};
  const int count = num_modes - m < 4 ? num_modes - m : 4;
  if (facet.port != none) {
    const double scale = trial_traction * sqrt(2 * facet.outer_impedance[c] / facet.measure);
    for (int s = 0; incoming && s < count; ++s) data[s] = scale * incoming[c * num_modes + m + s];
    return data;
  }
  if (facet.boundary_data == none) return data;
  for (int i = 0; i < D; ++i)
    for (int s = 0; s < count; ++s)
      data[s] += facet.frame[c][i] * prescribed[facet.boundary_data + i * num_modes + m + s];
  if (facet.kind[c] == BoundaryKind::velocity) return facet.impedance[c] * data;
  return facet.kind[c] == BoundaryKind::absorbing ? 0.5 * data : data;
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
  if (coefficients) {
    gradient_modes<D>(tables, derivative, coefficients, scratch.gradient, lanes);
    lanes.synchronize();
    velocity_and_strain<D>(&op.inverse_jacobian[0][0], scratch.gradient, stride, scratch.trace, lanes);
    lanes.synchronize();
  }
  for (int entry = lanes.first(); entry < num_fields * stride; entry += lanes.count()) {
    const int field = entry / stride, m = entry % stride;
    scratch.trace[entry] =
        (m < num_modes ? data[field * num_modes + m] : 0) - (coefficients ? scratch.trace[entry] : 0);
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
  double trial_velocity[D], trial_traction[D], test_velocity[D], test_traction[D];
  for (int c = 0; c < D; ++c)
    facet_factors<D>(facet, c, test_velocity[c], test_traction[c], trial_velocity[c], trial_traction[c]);
  for (int m = 4 * lanes.first(); m < stride; m += 4 * lanes.count()) {
    Vector4 flux[D][d] = {};
    for (int c = 0; c < D; ++c) {
      Vector4 velocity{}, traction{};
      for (int i = 0; i < D; ++i)
        for (int l = 0; l < d; ++l) {
          const Vector4 gradient = load4(scratch.gradient + (i * d + l) * stride + m);
          velocity += facet.velocity[c][i][l] * gradient;
          traction += facet.traction[c][i][l] * gradient;
        }
      const Vector4 jump = target_data<D>(facet, trial_traction[c], incoming, prescribed, num_modes, c, m) -
                           trial_velocity[c] * velocity - trial_traction[c] * traction;
      for (int i = 0; i < D; ++i)
        for (int l = 0; l < d; ++l)
          flux[i][l] +=
              (test_velocity[c] * facet.velocity[c][i][l] + test_traction[c] * facet.traction[c][i][l]) * jump;
      store4(scratch.trace + c * stride + m, jump);
      store4(scratch.trace + (D + c) * stride + m, (velocity + jump / facet.impedance[c]) * (traction + jump));
    }
    for (int i = 0; i < D; ++i)
      for (int l = 0; l < d; ++l) store4(scratch.flux + (l * D + i) * stride + m, flux[i][l]);
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
