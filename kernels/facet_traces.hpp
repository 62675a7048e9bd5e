#pragma once

#include "kernels/element_operator.hpp"
#include "kernels/lanes.hpp"
#include "kernels/simd.hpp"

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

}  // namespace tentpole
