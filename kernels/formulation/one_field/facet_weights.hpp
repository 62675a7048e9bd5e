#pragma once

#include "kernels/element/element_operator.hpp"

namespace tentpole {

/// Contraction weights of all facet terms of one element: facet f contributes weight[f][l, l'][i, j] <d_l phi_a d_l'
/// phi_b>. Its facets come in the order inflow, vertical, inclined.
template <int D>
struct FacetWeights {
  static constexpr int pairs = (D + 1) * (D + 1);
  const double* gram[D + 2];  ///< table of each facet, [a][l, l'][b]
  double weight[D + 2][pairs][D * D];
};

/// Facets with a term in the own matrix: all but those of outflow.
template <int D>
inline int num_weighted_facets(const ElementOperator<D>& op) {
  return op.num_inflow + op.num_vertical + op.num_inclined;
}

/// -int what^T A_N w over an inflow facet, with A_N = N_t diag(rho, C^-1) - [0 N_x; N_x^T 0]:
/// (-N_t) (rho v.v + E:C:E) + vhat.(sigma N_x) + (sigmahat N_x).v.
template <int D>
inline void inflow_weights(const ElementOperator<D>& op, const FrontFacet<D>& facet,
                           double (&weight)[(D + 1) * (D + 1)][D * D]) {
  const double* normal = facet.covector;
  const double minus_time = -normal[D];
  for (int l = 0; l <= D; ++l)
    for (int k = 0; k <= D; ++k) {
      const double *g = op.inverse_jacobian[l], *h = op.inverse_jacobian[k];
      double g_h = 0, g_normal = 0, h_normal = 0;
      for (int i = 0; i < D; ++i) g_h += g[i] * h[i], g_normal += g[i] * normal[i], h_normal += h[i] * normal[i];
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
          double value = minus_time * (op.lambda * g[i] * h[j] + op.mu * g[j] * h[i]) +
                         g[D] * (op.lambda * normal[i] * h[j] + op.mu * normal[j] * h[i]) +
                         h[D] * (op.lambda * normal[j] * g[i] + op.mu * normal[i] * g[j]);
          if (i == j)
            value +=
                minus_time * (op.density * g[D] * h[D] + op.mu * g_h) + op.mu * (g[D] * h_normal + h[D] * g_normal);
          weight[l * (D + 1) + k][i * D + j] = value;
        }
    }
}

/// Test and own trial factors of one component of a vertical facet: the residual term is
///   |F| < (Z vhat + shat)/Z (s - s*) >,  s - s* = trial(own) - data.
/// Interior: s - s* = Z/(Z + Z') [(s + Z' v) - incoming]; boundary: velocity Z v - Z vbar, traction s - sbar, absorbing
/// half the sum.
template <int D>
inline void facet_factors(const VerticalFacet<D>& facet, int c, double& test_velocity, double& test_traction,
                          double& trial_velocity, double& trial_traction) {
  const double impedance = facet.impedance[c];
  test_velocity = facet.measure;
  test_traction = facet.measure / impedance;
  if (facet.port != none) {
    const double outer = facet.outer_impedance[c], share = impedance / (impedance + outer);
    trial_velocity = share * outer;
    trial_traction = share;
  } else if (facet.kind[c] == BoundaryKind::velocity) {
    trial_velocity = impedance;
    trial_traction = 0;
  } else if (facet.kind[c] == BoundaryKind::traction) {
    trial_velocity = 0;
    trial_traction = 1;
  } else {
    trial_velocity = 0.5 * impedance;
    trial_traction = 0.5;
  }
}

template <int D>
inline void vertical_weights(const VerticalFacet<D>& facet, double (&weight)[(D + 1) * (D + 1)][D * D]) {
  constexpr int d = D + 1;
  double test[D][D][d], trial[D][D][d];
  for (int c = 0; c < D; ++c) {
    double test_velocity, test_traction, trial_velocity, trial_traction;
    facet_factors<D>(facet, c, test_velocity, test_traction, trial_velocity, trial_traction);
    for (int i = 0; i < D; ++i)
      for (int l = 0; l < d; ++l) {
        test[c][i][l] = test_velocity * facet.velocity[c][i][l] + test_traction * facet.traction[c][i][l];
        trial[c][i][l] = trial_velocity * facet.velocity[c][i][l] + trial_traction * facet.traction[c][i][l];
      }
  }
  for (int l = 0; l < d; ++l)
    for (int k = 0; k < d; ++k)
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
          double sum = 0;
          for (int c = 0; c < D; ++c) sum += test[c][i][l] * trial[c][j][k];
          weight[l * d + k][i * D + j] = sum;
        }
}

/// -int what^T A_N^- w of an inclined facet: the sum over incoming waves of wave(what) wave(w).
template <int D>
inline void inclined_weights(const InclinedFacet<D>& facet, double (&weight)[(D + 1) * (D + 1)][D * D]) {
  constexpr int d = D + 1;
  for (int l = 0; l < d; ++l)
    for (int k = 0; k < d; ++k)
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
          double sum = 0;
          for (int c = 0; c < facet.num_waves; ++c) sum += facet.incoming[c][i][l] * facet.incoming[c][j][k];
          weight[l * d + k][i * D + j] = sum;
        }
}

/// Weights of one of the facets, f < num_weighted_facets.
template <int D>
inline void build_facet_weights(const ElementOperator<D>& op, const ReferenceTablesView& tables, int f,
                                FacetWeights<D>& weights) {
  int facet;
  if (f < op.num_inflow) {
    facet = op.inflow[f].facet;
    inflow_weights<D>(op, op.inflow[f], weights.weight[f]);
  } else if (f < op.num_inflow + op.num_vertical) {
    const VerticalFacet<D>& vertical = op.vertical[f - op.num_inflow];
    facet = vertical.facet;
    vertical_weights<D>(vertical, weights.weight[f]);
  } else {
    const InclinedFacet<D>& inclined = op.inclined[f - op.num_inflow - op.num_vertical];
    facet = inclined.facet;
    inclined_weights<D>(inclined, weights.weight[f]);
  }
  weights.gram[f] = tables.facet_gram(facet);
}

}  // namespace tentpole
