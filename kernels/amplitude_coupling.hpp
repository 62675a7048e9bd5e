#pragma once

#include <cmath>

#include "kernels/amplitude_system.hpp"

namespace tentpole {

/// Scratch of the coupling solver.
struct CouplingScratch {
  static constexpr int max_iterations = 80;
  double* basis;       ///< [max_iterations + 1][num_unknowns]
  double* product;     ///< [size + 4]
  double* hessenberg;  ///< [max_iterations + 1][max_iterations]
  double* partial;     ///< [lanes]

  static long size(int system_size, int lanes) {
    return static_cast<long>(system_size) * (max_iterations + 2) + 4 + (max_iterations + 4L) * (max_iterations + 1) +
           lanes;
  }
  static CouplingScratch at(double* scratch, int system_size) {
    CouplingScratch parts;
    parts.basis = scratch;
    parts.product = parts.basis + static_cast<long>(system_size) * (max_iterations + 1);
    parts.hessenberg = parts.product + system_size + 4;
    parts.partial = parts.hessenberg + (max_iterations + 4L) * (max_iterations + 1);
    return parts;
  }
};

/// Scalar product that every lane gets; its value depends on the number of lanes only.
template <class Lanes>
inline double shared_dot(const double* left, const double* right, int n, double* partial, const Lanes& lanes) {
  if constexpr (!Lanes::cooperative) {
    return dot(left, right, n);
  } else {
    double sum = 0;
    for (int i = lanes.first(); i < n; i += lanes.count()) sum += left[i] * right[i];
    lanes.synchronize();
    partial[lanes.first()] = sum;
    lanes.synchronize();
    double total = 0;
    for (int lane = 0; lane < lanes.count(); ++lane) total += partial[lane];
    return total;
  }
}

/// x_R = E_RR t_R + E_RI (t_I + T_I E_IR t_R), the right-hand side of the system for x_R. Changes x_I too.
template <class Lanes>
inline void fold_right_side(const AmplitudeSystem& system, const double* t, double* x, double* product,
                            const Lanes& lanes) {
  exchange_amplitudes(system, independent_places(system), t, x, lanes);
  emit_amplitudes(system, independent_places(system), t, x, product, lanes);
  for (int i = lanes.first(); i < system.num_unknowns(); i += lanes.count()) product[i] = t[i];
  lanes.synchronize();
  exchange_amplitudes(system, unknown_places(system), product, x, lanes);
}

/// to = (I - E_RR T_R - E_RI T_I E_IR T_R) from, on the unknowns. x takes what arrives in I; `product` has size() + 4
/// entries.
template <class Lanes>
inline void apply_coupling(const AmplitudeSystem& system, const double* from, double* x, double* product, double* to,
                           const Lanes& lanes) {
  respond_at(system, unknown_places(system), from, product, lanes);
  exchange_amplitudes(system, independent_places(system), product, x, lanes);
  respond_at(system, independent_places(system), x, product, lanes);
  exchange_amplitudes(system, unknown_places(system), product, to, lanes);
  for (int i = lanes.first(); i < system.num_unknowns(); i += lanes.count()) to[i] = from[i] - to[i];
  lanes.synchronize();
}

/// Classical Gram-Schmidt, four basis vectors at a time: column[i] = basis_i . next, then next -= sum_i column[i]
/// basis_i. One pass suffices because I - T is well conditioned; the residual check of the patch would show a loss.
template <class Lanes>
inline void orthogonalize(const double* basis, int n, int count, double* next, double* column, double* partial,
                          const Lanes& lanes) {
  if constexpr (Lanes::cooperative) {
    for (int i = 0; i < count; ++i) {
      const double projection = shared_dot(basis + static_cast<long>(i) * n, next, n, partial, lanes);
      if (lanes.first() == 0) column[i] = projection;
    }
    lanes.synchronize();
    for (int j = lanes.first(); j < n; j += lanes.count())
      for (int i = 0; i < count; ++i) next[j] -= column[i] * basis[static_cast<long>(i) * n + j];
    lanes.synchronize();
  } else {
    int i = 0;
    for (; i + 4 <= count; i += 4) {
      const double* rows[4];
      Vector4 sum[4] = {};
      for (int r = 0; r < 4; ++r) rows[r] = basis + static_cast<long>(i + r) * n;
      int j = 0;
      for (; j + 4 <= n; j += 4) {
        const Vector4 value = load4(next + j);
        for (int r = 0; r < 4; ++r) sum[r] += value * load4(rows[r] + j);
      }
      for (int r = 0; r < 4; ++r) {
        column[i + r] = (sum[r][0] + sum[r][1]) + (sum[r][2] + sum[r][3]);
        for (int rest = j; rest < n; ++rest) column[i + r] += next[rest] * rows[r][rest];
      }
    }
    for (; i < count; ++i) column[i] = dot(basis + static_cast<long>(i) * n, next, n);
    for (i = 0; i + 4 <= count; i += 4) {
      const double* rows = basis + static_cast<long>(i) * n;
      for (int j = 0; j < n; ++j)
        next[j] -= (column[i] * rows[j] + column[i + 1] * rows[n + j]) +
                   (column[i + 2] * rows[2L * n + j] + column[i + 3] * rows[3L * n + j]);
    }
    for (; i < count; ++i)
      for (int j = 0; j < n; ++j) next[j] -= column[i] * basis[static_cast<long>(i) * n + j];
  }
}

/// Solves for x_R; on entry it holds the folded right-hand side. Returns the number of steps, or -1 when the tolerance
/// (relative residual 1e-14) was not reached in max_iterations. Source: Saad and Schultz, SIAM J. Sci. Stat. Comput. 7
/// (1986) 856.
template <class Lanes>
inline int solve_unknowns(const AmplitudeSystem& system, double* x, const CouplingScratch& scratch,
                          const Lanes& lanes) {
  constexpr int limit = CouplingScratch::max_iterations;
  constexpr double tolerance = 1e-14;
  const int n = system.num_unknowns();
  const double norm = sqrt(shared_dot(x, x, n, scratch.partial, lanes));
  if (!(norm > 0)) return norm == 0 ? 0 : -1;
  double *hessenberg = scratch.hessenberg, *cosine = hessenberg + (limit + 1) * limit, *sine = cosine + limit,
         *right = sine + limit;
  for (int i = lanes.first(); i < n; i += lanes.count()) scratch.basis[i] = x[i] / norm;
  if (lanes.first() == 0) right[0] = norm;
  lanes.synchronize();
  int count = 0;
  double residual = norm;
  while (count < limit && residual > tolerance * norm) {
    double* next = scratch.basis + static_cast<long>(count + 1) * n;
    double* column = hessenberg + count * (limit + 1);
    apply_coupling(system, scratch.basis + static_cast<long>(count) * n, x, scratch.product, next, lanes);
    orthogonalize(scratch.basis, n, count + 1, next, column, scratch.partial, lanes);
    const double length = sqrt(shared_dot(next, next, n, scratch.partial, lanes));
    if (length > 0)
      for (int j = lanes.first(); j < n; j += lanes.count()) next[j] /= length;
    lanes.synchronize();
    if (lanes.first() == 0) {
      for (int i = 0; i < count; ++i) {
        const double upper = column[i];
        column[i] = cosine[i] * upper + sine[i] * column[i + 1];
        column[i + 1] = -sine[i] * upper + cosine[i] * column[i + 1];
      }
      const double radius = sqrt(column[count] * column[count] + length * length);
      cosine[count] = column[count] / radius;
      sine[count] = length / radius;
      column[count] = radius;
      right[count + 1] = -sine[count] * right[count];
      right[count] *= cosine[count];
    }
    lanes.synchronize();
    residual = fabs(right[count + 1]);
    ++count;
  }
  if (lanes.first() == 0)
    for (int i = count - 1; i >= 0; --i) {
      for (int j = i + 1; j < count; ++j) right[i] -= hessenberg[j * (limit + 1) + i] * right[j];
      right[i] /= hessenberg[i * (limit + 1) + i];
    }
  lanes.synchronize();
  for (int j = lanes.first(); j < n; j += lanes.count()) {
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += right[i] * scratch.basis[static_cast<long>(i) * n + j];
    x[j] = sum;
  }
  lanes.synchronize();
  return residual <= tolerance * norm ? count : -1;
}

/// Solves for the incoming amplitudes x [size] when the elements emit t [size] without any. Returns the number of
/// products with T, the folding of the right-hand side and the recovery of x_I being one together; or -1 as
/// solve_unknowns. The product of the scratch keeps the waves t + T x that R emits.
template <class Lanes>
inline int solve_coupling(const AmplitudeSystem& system, const double* t, double* x, const CouplingScratch& scratch,
                          const Lanes& lanes) {
  fold_right_side(system, t, x, scratch.product, lanes);
  const int steps = solve_unknowns(system, x, scratch, lanes);
  emit_amplitudes(system, unknown_places(system), t, x, scratch.product, lanes);
  exchange_amplitudes(system, independent_places(system), scratch.product, x, lanes);
  return steps < 0 ? -1 : steps + 1;
}

}  // namespace tentpole
