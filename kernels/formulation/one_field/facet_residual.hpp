#pragma once

#include "kernels/patch/patch_workspace.hpp"

namespace tentpole {

/// Flux of -A_N j, j the jump (external - internal) of (v, E) on an inflow facet: flux[l][i] of modes m .. m + 3.
template <int D>
inline void inflow_flux(const ElementOperator<D>& op, const FrontFacet<D>& facet,
                        const Vector4 (&jump)[D + num_symmetric(D)], int stride, int m, double* flux) {
  constexpr int d = D + 1;
  const double* normal = facet.covector;
  const double minus_time = -normal[D];
  Vector4 strain[num_symmetric(D)], sigma[D][D], traction[D], velocity_normal{};
  for (int s = 0; s < num_symmetric(D); ++s) strain[s] = jump[D + s];
  for (int i = 0; i < D; ++i) {
    velocity_normal += jump[i] * normal[i];
    traction[i] = Vector4{};
    for (int j = 0; j < D; ++j) {
      sigma[i][j] = stress<D>(op, strain, i, j);
      traction[i] += sigma[i][j] * normal[j];
    }
  }
  for (int l = 0; l < d; ++l) {
    const double* g = op.inverse_jacobian[l];
    double g_normal = 0;
    Vector4 g_velocity{};
    for (int j = 0; j < D; ++j) g_normal += g[j] * normal[j], g_velocity += g[j] * jump[j];
    for (int i = 0; i < D; ++i) {
      Vector4 value = g[D] * (minus_time * op.density * jump[i] + traction[i]) + op.lambda * g[i] * velocity_normal +
                      op.mu * (g_normal * jump[i] + g_velocity * normal[i]);
      for (int p = 0; p < D; ++p) value += minus_time * sigma[i][p] * g[p];
      store4(flux + (l * D + i) * stride + m, value);
    }
  }
}

/// Jump w_ext - w and flux -A_N (w_ext - w) of four modes of one inflow facet. `data`: a block in the layout of initial
/// data.
template <int D>
inline void inflow_residual(const PatchWorkspace<D>& workspace, const ElementWorkspace<D>& own,
                            const FrontFacet<D>& facet, const double* data, bool has_solution, int m) {
  constexpr int num_fields = D + num_symmetric(D);
  const int stride = workspace.tables.facet_stride, num_modes = workspace.tables.num_facet_modes;
  Vector4 jump[num_fields] = {};
  if (has_solution)
    velocity_and_strain<D>(&own.op().inverse_jacobian[0][0], own.gradient(facet.facet), stride, m, jump);
  for (int field = 0; field < num_fields; ++field) {
    jump[field] = load_modes(data + field * num_modes, num_modes, m) - jump[field];
    store4(own.trace(facet.facet) + field * stride + m, jump[field]);
  }
  inflow_flux<D>(own.op(), facet, jump, stride, m, own.flux(facet.facet));
}

/// Flux of the sum over incoming waves of wave(what) (amplitude - wave(w)), four modes of one inclined facet; the jumps
/// of the waves go to the trace. Only for solutions.
template <int D>
inline void inclined_residual(const PatchWorkspace<D>& workspace, const ElementWorkspace<D>& own,
                              const InclinedFacet<D>& facet, const double* incoming, int m) {
  constexpr int d = D + 1;
  const int stride = workspace.tables.facet_stride, num_modes = workspace.tables.num_facet_modes;
  const double* gradient = own.gradient(facet.facet);
  Vector4 flux[D][d] = {};
  for (int c = 0; c < facet.num_waves; ++c) {
    Vector4 jump = load_modes(incoming + c * num_modes, num_modes, m);
    for (int i = 0; i < D; ++i)
      for (int l = 0; l < d; ++l) jump -= facet.incoming[c][i][l] * load4(gradient + (i * d + l) * stride + m);
    for (int i = 0; i < D; ++i)
      for (int l = 0; l < d; ++l) flux[i][l] += facet.incoming[c][i][l] * jump;
    store4(own.trace(facet.facet) + c * stride + m, jump);
  }
  for (int i = 0; i < D; ++i)
    for (int l = 0; l < d; ++l) store4(own.flux(facet.facet) + (l * D + i) * stride + m, flux[i][l]);
}

/// What the residual of a vertical facet is made of.
struct VerticalSource {
  const double* incoming;    ///< interior: amplitudes of this facet [c][m]
  const double* prescribed;  ///< boundary: data blocks, in them [i][m]
  bool has_solution;         ///< or the solution counts as zero
};

/// Data of component c, four modes, with which the jump of a vertical facet is
///   s* - s = data - trial(own)
/// (facet_weights.hpp).
template <int D>
inline Vector4 target_data(const VerticalFacet<D>& facet, int c, double trial_traction, const VerticalSource& source,
                           int num_modes, int m) {
  if (facet.port != none) {
    const double scale = trial_traction * sqrt(2 * facet.outer_impedance[c] / facet.measure);
    return scale * load_modes(source.incoming + c * num_modes, num_modes, m);
  }
  Vector4 data{};
  if (facet.boundary_data == none) return data;
  for (int i = 0; i < D; ++i)
    data += facet.frame[c][i] * load_modes(source.prescribed + facet.boundary_data + i * num_modes, num_modes, m);
  if (facet.kind[c] == BoundaryKind::velocity) return facet.impedance[c] * data;
  return facet.kind[c] == BoundaryKind::absorbing ? 0.5 * data : data;
}

/// Flux of (vhat + shat/Z).(s* - s), four modes of one vertical facet; the trace takes the jumps s*_c - s_c and then
/// the powers v*_c s*_c.
template <int D>
inline void vertical_residual(const PatchWorkspace<D>& workspace, const ElementWorkspace<D>& own,
                              const VerticalFacet<D>& facet, const VerticalSource& source, int m) {
  constexpr int d = D + 1;
  const int stride = workspace.tables.facet_stride, num_modes = workspace.tables.num_facet_modes;
  const double* gradient = own.gradient(facet.facet);
  Vector4 flux[D][d] = {};
  for (int c = 0; c < D; ++c) {
    double test_velocity, test_traction, trial_velocity, trial_traction;
    facet_factors<D>(facet, c, test_velocity, test_traction, trial_velocity, trial_traction);
    Vector4 velocity{}, traction{};
    for (int i = 0; i < D && source.has_solution; ++i)
      for (int l = 0; l < d; ++l) {
        const Vector4 derivative = load4(gradient + (i * d + l) * stride + m);
        velocity += facet.velocity[c][i][l] * derivative;
        traction += facet.traction[c][i][l] * derivative;
      }
    const Vector4 jump = target_data<D>(facet, c, trial_traction, source, num_modes, m) - trial_velocity * velocity -
                         trial_traction * traction;
    for (int i = 0; i < D; ++i)
      for (int l = 0; l < d; ++l)
        flux[i][l] += (test_velocity * facet.velocity[c][i][l] + test_traction * facet.traction[c][i][l]) * jump;
    store4(own.trace(facet.facet) + c * stride + m, jump);
    store4(own.trace(facet.facet) + (D + c) * stride + m, (velocity + jump / facet.impedance[c]) * (traction + jump));
  }
  for (int i = 0; i < D; ++i)
    for (int l = 0; l < d; ++l) store4(own.flux(facet.facet) + (l * D + i) * stride + m, flux[i][l]);
}

/// int_f |N_t| R_r . u over one facet with N_t < 0, with the displacement modes [D][D + 1] of u there.
template <int D>
inline double rigid_amount(const RigidFacet<D>& rigid, int r, const double* displacement) {
  double amount = 0;
  for (int i = 0; i < D; ++i)
    for (int m = 0; m <= D; ++m) amount += rigid.modes[r][i][m] * displacement[i * (D + 1) + m];
  return rigid.root * amount;
}

/// What one facet gives to the balance of its element, from its jumps.
template <int D>
inline FacetBalance inflow_balance(const PatchWorkspace<D>& workspace, const ElementWorkspace<D>& own,
                                   const FrontFacet<D>& facet) {
  return {-facet_energy<D>(own.op(), facet.covector, own.trace(facet.facet), workspace.tables.facet_stride,
                           workspace.tables.num_facet_modes),
          0};
}
template <int D>
inline FacetBalance inclined_balance(const PatchWorkspace<D>& workspace, const ElementWorkspace<D>& own,
                                     const InclinedFacet<D>& facet) {
  const double* jumps = own.trace(facet.facet);
  const int stride = workspace.tables.facet_stride, num_modes = workspace.tables.num_facet_modes;
  double square = 0;
  for (int c = 0; c < facet.num_waves; ++c)
    for (int m = 0; m < num_modes; ++m) square += jumps[c * stride + m] * jumps[c * stride + m];
  return {0.5 * square, 0};
}
template <int D>
inline FacetBalance vertical_balance(const PatchWorkspace<D>& workspace, const ElementWorkspace<D>& own,
                                     const VerticalFacet<D>& facet) {
  const double* jumps = own.trace(facet.facet);
  const int stride = workspace.tables.facet_stride, num_modes = workspace.tables.num_facet_modes;
  FacetBalance balance{0, 0};
  for (int c = 0; c < D; ++c)
    for (int m = 0; m < num_modes; ++m) {
      balance.dissipation += facet.measure * jumps[c * stride + m] * jumps[c * stride + m] / facet.impedance[c];
      if (facet.port == none) balance.external_work += facet.measure * jumps[(D + c) * stride + m];
    }
  return balance;
}

}  // namespace tentpole
