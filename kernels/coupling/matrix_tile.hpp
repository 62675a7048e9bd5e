#pragma once

#include "kernels/element/simd.hpp"

namespace tentpole {

/// 4 x (4 vectors) entries of a row-major matrix in registers.
template <int vectors>
inline void load_tile(const double* from, long stride, Vector4 (&tile)[4][vectors]) {
  for (int r = 0; r < 4; ++r)
    for (int s = 0; s < vectors; ++s) tile[r][s] = load4(from + r * stride + 4 * s);
}

template <int vectors>
inline void store_tile(double* to, long stride, const Vector4 (&tile)[4][vectors]) {
  for (int r = 0; r < 4; ++r)
    for (int s = 0; s < vectors; ++s) store4(to + r * stride + 4 * s, tile[r][s]);
}

/// Unblocked LU of the diagonal block and the inverse of its U; false at a vanishing or not finite pivot.
template <int width>
inline bool factor_diagonal_block(double* block, long stride, double (&inverse_upper)[width][width]) {
  bool regular = true;
  for (int k = 0; k < width; ++k) {
    const double pivot = block[k * stride + k];
    if (!(pivot > 0 || pivot < 0)) regular = false;
    const double inverse = 1 / pivot;
    for (int i = k + 1; i < width; ++i) {
      const double factor = block[i * stride + k] * inverse;
      block[i * stride + k] = factor;
      for (int j = k + 1; j < width; ++j) block[i * stride + j] -= factor * block[k * stride + j];
    }
  }
  for (int column = 0; column < width; ++column)
    for (int i = width - 1; i >= 0; --i) {
      double sum = i == column ? 1.0 : 0.0;
      for (int k = i + 1; k <= column; ++k) sum -= block[i * stride + k] * inverse_upper[k][column];
      inverse_upper[i][column] = i > column ? 0.0 : sum / block[i * stride + i];
    }
  return regular;
}

}  // namespace tentpole
