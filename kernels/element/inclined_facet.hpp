#pragma once

#include <cmath>

#include "common/material.hpp"
#include "common/simplex.hpp"

namespace tentpole {

template <int D>
struct RigidFacet;  // kernels/element/element_geometry.hpp

/// A facet inside a patch that is not parallel to the time axis (inclined tent poles, vertex deletions, flips): upwind
/// by characteristics, one material on both sides (docs/formulation.md, Element problem). With the outward covector N
/// dA, |N| = |N_x|, n = N_x / |N|, the eigenvalues of A_N r = lambda A_0 r and the waves r^T A_0 w of unit energy are
///   N_t -+ |N| c_p:  (Z_p v_n +- s_n) / (c_p sqrt(2 rho)),     N_t -+ |N| c_s:  (Z_s v_t +- s_t) / (c_s sqrt(2 rho)),
///   N_t:  alpha E_tt with alpha^2 = 4 mu (lambda + mu) / (lambda + 2 mu)   (D = 2; stress without traction on N_x).
/// Waves with lambda < 0 come in: wave_c(w) = sqrt(-lambda_c) r_c^T A_0 w. The element takes wave_c of its neighbour
/// instead of its own. Coefficients are of the reference derivatives: wave_c = [c][i][l] d_l u_i.
template <int D>
struct InclinedFacet {
  static constexpr int num_waves = D == 1 ? 2 : 5, max_per_element = D < 3 ? D + 1 : 1;
  int facet;
  int port;
  int rigid;                             ///< index among the element's rigid facets where N_t < 0, otherwise none
  const RigidFacet<D>* receiver;         ///< the other side's rigid facet where it has N_t < 0, otherwise nullptr
  double time_part;                      ///< N_t dA
  double incoming[num_waves][D][D + 1];  ///< of waves that this side takes in; zero for the others
  double outgoing[num_waves][D][D + 1];  ///< of waves that the other side takes in
};

/// Coefficients of the incoming waves of the side with outward covector N, on reference derivatives of an element with
/// this J^-1; `wave` may be evaluated on either side.
template <int D>
inline void incoming_waves(const Material& material, const double (&inverse_jacobian)[D + 1][D + 1],
                           const double (&covector)[D + 1], double (&wave)[InclinedFacet<D>::num_waves][D][D + 1]) {
  constexpr int d = D + 1;
  double length = 0;
  for (int i = 0; i < D; ++i) length += covector[i] * covector[i];
  length = sqrt(length);
  double frame[D][D] = {};
  frame[0][0] = 1;
  if (length > 0)
    for (int i = 0; i < D; ++i) frame[0][i] = covector[i] / length;
  if constexpr (D == 2) frame[1][0] = -frame[0][1], frame[1][1] = frame[0][0];
  const double time_part = covector[D];
  const auto root_of = [](double eigenvalue) { return eigenvalue < 0 ? sqrt(-eigenvalue) : 0.0; };
  for (int c = 0; c < D; ++c) {
    const double speed = c == 0 ? material.dilatational_speed() : material.shear_speed();
    const double impedance = material.density * speed, unit = 1 / (speed * sqrt(2 * material.density));
    for (int side = 0; side < 2; ++side) {
      const double sign = side == 0 ? 1.0 : -1.0, factor = unit * root_of(time_part - sign * length * speed);
      for (int l = 0; l < d; ++l) {
        const double* gradient = inverse_jacobian[l];
        double along_normal = 0, along_frame = 0;
        for (int i = 0; i < D; ++i) {
          along_normal += gradient[i] * frame[0][i];
          along_frame += gradient[i] * frame[c][i];
        }
        for (int i = 0; i < D; ++i) {
          const double traction = material.mu * (frame[c][i] * along_normal + frame[0][i] * along_frame) +
                                  (c == 0 ? material.lambda * gradient[i] : 0.0);
          wave[2 * c + side][i][l] = factor * (impedance * frame[c][i] * gradient[D] + sign * traction);
        }
      }
    }
  }
  if constexpr (D == 2) {
    const double lambda = material.lambda, mu = material.mu;
    const double factor = root_of(time_part) * sqrt(4 * mu * (lambda + mu) / (lambda + 2 * mu));
    for (int l = 0; l < d; ++l) {
      const double along = inverse_jacobian[l][0] * frame[1][0] + inverse_jacobian[l][1] * frame[1][1];
      for (int i = 0; i < D; ++i) wave[4][i][l] = factor * frame[1][i] * along;
    }
  }
}

/// Fills incoming, outgoing and time_part from the facet's outward covector.
template <int D>
inline void build_inclined_facet(const Material& material, const double (&inverse_jacobian)[D + 1][D + 1],
                                 const double (&covector)[D + 1], InclinedFacet<D>& inclined) {
  double opposite[D + 1];
  for (int j = 0; j <= D; ++j) opposite[j] = -covector[j];
  inclined.time_part = covector[D];
  incoming_waves<D>(material, inverse_jacobian, covector, inclined.incoming);
  incoming_waves<D>(material, inverse_jacobian, opposite, inclined.outgoing);
}

}  // namespace tentpole
