#pragma once

#include "kernels/element/element_operator.hpp"
#include "kernels/element/simd.hpp"

namespace tentpole {

/// Traces on one facet in its modes: velocity [i][m], strain (xx, yy, zz, xy, yz, xz) [s][m], stride facet_stride.
/// Everything works on blocks of four modes, which are independent of each other.

/// Blocks of four modes of a facet.
inline int num_mode_blocks(const ReferenceTablesView& tables) {
  return tables.facet_stride / 4;
}

/// Modes m .. m + 3 of an array of num_modes; zero where it ends. (Entries of a vector are named by constants: others
/// go through the stack of a GPU.)
inline Vector4 load_modes(const double* modes, int num_modes, int m) {
  if (m + 4 <= num_modes) return load4(modes + m);
  Vector4 loaded{};
  for (int s = 0; s < 3; ++s)
    if (m + s < num_modes) loaded[s] = modes[m + s];
  return loaded;
}
/// Stores those of the four modes that the array has, `step` apart.
inline void store_modes(Vector4 values, int num_modes, int m, double* modes, long step = 1) {
  if (step == 1 && m + 4 <= num_modes) return store4(modes + m, values);
  for (int s = 0; s < 4; ++s)
    if (m + s < num_modes) modes[(m + s) * step] = values[s];
}

/// Gradient modes G[i][l][m] = sum_a c[i, a] <d_l phi_a psi_m> of four modes: block = (i, l, m / 4), the last fastest.
template <int D>
inline void gradient_block(const ReferenceTablesView& tables, const double* derivative, const double* coefficients,
                           double* gradient, int block) {
  constexpr int d = D + 1;
  const int num_basis = tables.num_basis, stride = tables.facet_stride, num_blocks = num_mode_blocks(tables);
  const int i = block / (d * num_blocks), l = block / num_blocks % d, m = block % num_blocks * 4;
  Vector4 sum{};
  const double* table = derivative + static_cast<long>(l) * num_basis * stride + m;
  for (int a = 0; a < num_basis; ++a)
    sum += coefficients[i * num_basis + a] * load4(table + static_cast<long>(a) * stride);
  store4(gradient + (i * d + l) * stride + m, sum);
}

/// Tests mode fluxes of one facet with phi_a: sum[i] += sum_l sum_m <d_l phi_a psi_m> flux[l][i][m], in four partial
/// sums.
template <int D>
inline void test_facet(const ReferenceTablesView& tables, const double* derivative, const double* flux, int a,
                       Vector4 (&sum)[D]) {
  const int num_basis = tables.num_basis, stride = tables.facet_stride;
  for (int l = 0; l <= D; ++l) {
    const double* table = derivative + (static_cast<long>(l) * num_basis + a) * stride;
    for (int m = 0; m < stride; m += 4) {
      const Vector4 modes = load4(table + m);
      for (int i = 0; i < D; ++i) sum[i] += modes * load4(flux + (l * D + i) * stride + m);
    }
  }
}

/// Velocity and strain of modes m .. m + 3 from gradient modes and J^-1 (row-major [l][j], stride d).
template <int D>
inline void velocity_and_strain(const double* inverse_jacobian, const double* gradient, int stride, int m,
                                Vector4 (&trace)[D + num_symmetric(D)]) {
  constexpr int d = D + 1;
  Vector4 physical[D][d];
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < d; ++j) {
      Vector4 sum{};
      for (int l = 0; l < d; ++l) sum += inverse_jacobian[l * d + j] * load4(gradient + (i * d + l) * stride + m);
      physical[i][j] = sum;
    }
  for (int i = 0; i < D; ++i) {
    trace[i] = physical[i][D];
    for (int j = i; j < D; ++j) trace[D + symmetric_index(D, i, j)] = 0.5 * (physical[i][j] + physical[j][i]);
  }
}

/// sigma_ij from strain components; Number is double or Vector4.
template <int D, class Number>
inline Number stress(const ElementOperator<D>& op, const Number (&strain)[num_symmetric(D)], int i, int j) {
  Number value = 2 * op.mu * strain[symmetric_index(D, i, j)];
  if (i == j)
    for (int p = 0; p < D; ++p) value += op.lambda * strain[p];
  return value;
}

/// Strain components at one mode of a trace.
template <int D>
inline void load_strain(const double* trace, int stride, int m, double (&strain)[num_symmetric(D)]) {
  for (int s = 0; s < num_symmetric(D); ++s) strain[s] = trace[(D + s) * stride + m];
}

/// int 1/2 w^T A_N w over a facet with covector N dA: N_t (rho v.v + E:C:E)/2 - v.(sigma N_x). Uniform in the modes.
template <int D>
inline double facet_energy(const ElementOperator<D>& op, const double* covector, const double* trace, int stride,
                           int num_modes) {
  double energy = 0;
  for (int m = 0; m < num_modes; ++m) {
    double kinetic = 0, elastic = 0, power = 0, strain[num_symmetric(D)];
    load_strain<D>(trace, stride, m, strain);
    for (int i = 0; i < D; ++i) {
      const double velocity = trace[i * stride + m];
      kinetic += velocity * velocity;
      for (int j = 0; j < D; ++j) {
        const double sigma = stress<D>(op, strain, i, j);
        elastic += sigma * strain[symmetric_index(D, i, j)];
        power += velocity * sigma * covector[j];
      }
    }
    energy += 0.5 * covector[D] * (op.density * kinetic + elastic) - power;
  }
  return energy;
}

/// Entry (i, m') of the displacement modes [D][D + 1] of the coefficients on the facet with this code.
template <int D>
inline double displacement_mode(const ReferenceTablesView& tables, int code, const double* coefficients, int entry) {
  constexpr int d = D + 1;
  const double* value = tables.facet_value(code);
  double sum = 0;
  for (int a = 0; a < tables.num_basis; ++a)
    sum += coefficients[entry / d * tables.num_basis + a] * value[a * d + entry % d];
  return sum;
}

}  // namespace tentpole
