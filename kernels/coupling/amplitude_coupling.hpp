#pragma once

#include <cmath>

#include "kernels/coupling/amplitude_system.hpp"

namespace tentpole {

/// Scratch of the coupling solver.
struct CouplingScratch {
  static constexpr int max_iterations = 80;
  double* basis;       ///< [max_iterations + 1][num_unknowns]
  double* product;     ///< [size + 4]
  double* hessenberg;  ///< [max_iterations][max_iterations + 1] by columns, then cosines, sines, right-hand side
  double* partial;     ///< [max_iterations + 1][lanes]

  double* column(int count) const { return hessenberg + count * (max_iterations + 1); }
  double* cosine() const { return column(max_iterations); }
  double* sine() const { return cosine() + max_iterations; }
  double* right() const { return sine() + max_iterations; }

  static long size(int system_size, int lanes) {
    return static_cast<long>(system_size) * (max_iterations + 2) + 4 + (max_iterations + 4L) * (max_iterations + 1) +
           lanes * (max_iterations + 1L);
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

/// What a lane adds to a scalar product: entries lane, lane + count, ... in every function here, so that a vector that
/// is used by entries alone needs no meeting of the lanes.
template <class Lanes>
inline double dot_share(const double* left, const double* right, int n, const Lanes& lanes) {
  if constexpr (!Lanes::cooperative) {
    return dot(left, right, n);
  } else {
    double sum = 0;
    for (int i = lanes.first(); i < n; i += lanes.count()) sum += left[i] * right[i];
    return sum;
  }
}

/// Sum of [lanes] numbers in four chains, whose value depends on the number of lanes only.
inline double sum_of_lanes(const double* partial, int num_lanes) {
  Vector4 chains{};
  int lane = 0;
  for (; lane + 4 <= num_lanes; lane += 4) chains += load4(partial + lane);
  double sum = (chains[0] + chains[1]) + (chains[2] + chains[3]);
  for (; lane < num_lanes; ++lane) sum += partial[lane];
  return sum;
}

/// Scalar product that every lane gets, of entries that the lane wrote itself. The lanes meet once inside, and must
/// meet again before `partial` is used anew.
template <class Lanes>
inline double shared_dot(const double* left, const double* right, int n, double* partial, const Lanes& lanes) {
  const double share = dot_share(left, right, n, lanes);
  if constexpr (!Lanes::cooperative) {
    return share;
  } else {
    partial[lanes.first()] = share;
    lanes.synchronize();
    return sum_of_lanes(partial, lanes.count());
  }
}

/// x_R = E_RR t_R + E_RI (t_I + T_I E_IR t_R), the right-hand side of the system for x_R. Changes x_I too.
template <class Lanes>
TENTPOLE_STEP void fold_right_side(const AmplitudeSystem& system, const double* t, double* x, double* product,
                                   const Lanes& lanes) {
  exchange_amplitudes(system, independent_places(system), t, x, lanes);
  emit_amplitudes(system, independent_places(system), t, x, product, lanes);
  for (int i = lanes.first(); i < system.num_unknowns(); i += lanes.count()) product[i] = t[i];
  lanes.synchronize();
  exchange_amplitudes(system, unknown_places(system), product, x, lanes);
}

/// to = (I - E_RR T_R - E_RI T_I E_IR T_R) from, on the unknowns. x takes what arrives in I; `product` has size() + 4
/// entries. A lane knows its own entries of the result only (dot_share).
template <class Lanes>
inline void apply_coupling(const AmplitudeSystem& system, const double* from, double* x, double* product, double* to,
                           const Lanes& lanes) {
  respond_at(system, unknown_places(system), from, product, lanes);
  exchange_amplitudes(system, independent_places(system), product, x, lanes);
  respond_at(system, independent_places(system), x, product, lanes);
  exchange_amplitudes(system, unknown_places(system), product, to, lanes);
  for (int i = lanes.first(); i < system.num_unknowns(); i += lanes.count()) to[i] = from[i] - to[i];
}

/// Classical Gram-Schmidt of vector `count` of the basis, `next`, against those before it, four at a time: column[i] =
/// basis_i . next, then next -= sum_i column[i] basis_i. One pass suffices because I - T is well conditioned; the
/// residual check of the patch would show a loss. Before and after it a lane knows its own entries of `next` only.
template <class Lanes>
inline void orthogonalize(const CouplingScratch& scratch, int n, int count, const Lanes& lanes) {
  const double* basis = scratch.basis;
  double *next = scratch.basis + static_cast<long>(count) * n, *column = scratch.column(count - 1),
         *partial = scratch.partial;
  if constexpr (Lanes::cooperative) {
    for (int i = 0; i < count; ++i)
      partial[i * lanes.count() + lanes.first()] = dot_share(basis + static_cast<long>(i) * n, next, n, lanes);
    lanes.synchronize();
    for (int i = lanes.first(); i < count; i += lanes.count())
      column[i] = sum_of_lanes(partial + i * lanes.count(), lanes.count());
    lanes.synchronize();
    for (int j = lanes.first(); j < n; j += lanes.count())
      for (int i = 0; i < count; ++i) next[j] -= column[i] * basis[static_cast<long>(i) * n + j];
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

/// Turns column `count` of the Hessenberg matrix, whose next entry is `length`, into one of a triangle by Givens
/// rotations, and its right-hand side with it. One lane calls it.
inline void rotate_column(const CouplingScratch& scratch, int count, double length) {
  double *column = scratch.column(count), *cosine = scratch.cosine(), *sine = scratch.sine(), *right = scratch.right();
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

/// Solves the triangle of `count` rotated columns in place of its right-hand side. One lane calls it.
inline void solve_hessenberg(const CouplingScratch& scratch, int count) {
  double* right = scratch.right();
  for (int i = count - 1; i >= 0; --i) {
    for (int j = i + 1; j < count; ++j) right[i] -= scratch.column(j)[i] * right[j];
    right[i] /= scratch.column(i)[i];
  }
}

/// Solves for x_R; on entry it holds the folded right-hand side. Returns the number of steps, or -1 when the tolerance
/// (relative residual 1e-14) was not reached in max_iterations. Source: Saad and Schultz, SIAM J. Sci. Stat. Comput. 7
/// (1986) 856.
template <class Lanes>
TENTPOLE_STEP int solve_unknowns(const AmplitudeSystem& system, double* x, const CouplingScratch& scratch,
                                 const Lanes& lanes) {
  constexpr int limit = CouplingScratch::max_iterations;
  constexpr double tolerance = 1e-14;
  const int n = system.num_unknowns();
  const double norm = sqrt(shared_dot(x, x, n, scratch.partial, lanes));
  if (!(norm > 0)) return norm == 0 ? 0 : -1;
  double* right = scratch.right();
  for (int i = lanes.first(); i < n; i += lanes.count()) scratch.basis[i] = x[i] / norm;
  if (lanes.first() == 0) right[0] = norm;
  lanes.synchronize();
  int count = 0;
  double residual = norm;
  while (count < limit && residual > tolerance * norm) {
    double* next = scratch.basis + static_cast<long>(count + 1) * n;
    apply_coupling(system, scratch.basis + static_cast<long>(count) * n, x, scratch.product, next, lanes);
    orthogonalize(scratch, n, count + 1, lanes);
    const double length = sqrt(shared_dot(next, next, n, scratch.partial, lanes));
    if (length > 0)
      for (int j = lanes.first(); j < n; j += lanes.count()) next[j] /= length;
    if (lanes.first() == 0) rotate_column(scratch, count, length);
    lanes.synchronize();
    residual = fabs(right[count + 1]);
    ++count;
  }
  if (lanes.first() == 0) solve_hessenberg(scratch, count);
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
