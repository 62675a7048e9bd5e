#pragma once

#include "kernels/coupling/matrix_tile.hpp"

namespace tentpole {

/// Partial LU without pivoting of [A P b; O^T 0 0] by one thread (kernels/coupling/eliminate.hpp says what it leaves):
/// left-looking by column strips of 8 or 4. A strip is packed, and every 4 x 8 tile meets all its updates in registers.

/// sum[r][s] -= rows of `left` (4 rows, stride) times the packed strip (length k).
template <int vectors>
inline void subtract_product(const double* left, long stride, const double* packed, int length,
                             Vector4 (&sum)[4][vectors]) {
  for (int k = 0; k < length; ++k) {
    Vector4 right[vectors];
    for (int s = 0; s < vectors; ++s) right[s] = load4(packed + (k * vectors + s) * 4);
    for (int r = 0; r < 4; ++r)
      for (int s = 0; s < vectors; ++s) sum[r][s] -= left[r * stride + k] * right[s];
  }
}

/// Rows above the strip's diagonal block: U = L^-1 (strip), also packed.
template <int vectors>
inline void forward_strip(double* matrix, long stride, int column, int num_rows, double* packed) {
  for (int row = 0; row < num_rows; row += 4) {
    Vector4 tile[4][vectors];
    double* target = matrix + row * stride + column;
    const double* left = matrix + row * stride;
    load_tile<vectors>(target, stride, tile);
    subtract_product<vectors>(left, stride, packed, row, tile);
    for (int r = 1; r < 4; ++r)
      for (int k = 0; k < r; ++k)
        for (int s = 0; s < vectors; ++s) tile[r][s] -= left[r * stride + row + k] * tile[k][s];
    store_tile<vectors>(target, stride, tile);
    store_tile<vectors>(packed + row * vectors * 4, vectors * 4, tile);
  }
}

/// Rows first, ..., last - 1.
struct RowRange {
  int first;
  int last;
};

/// These rows lose the contribution of the packed rows 0..length.
template <int vectors>
inline void update_rows(double* matrix, long stride, int column, RowRange rows, const double* packed, int length) {
  for (int row = rows.first; row < rows.last; row += 4) {
    Vector4 tile[4][vectors];
    load_tile<vectors>(matrix + row * stride + column, stride, tile);
    subtract_product<vectors>(matrix + row * stride, stride, packed, length, tile);
    store_tile<vectors>(matrix + row * stride + column, stride, tile);
  }
}

/// Rows below the diagonal block: update, then L = C U^-1.
template <int vectors>
inline void panel_rows(double* matrix, long stride, int column, RowRange rows, const double* packed,
                       const double (&inverse_upper)[4 * vectors][4 * vectors]) {
  for (int row = rows.first; row < rows.last; row += 4) {
    Vector4 tile[4][vectors];
    double* target = matrix + row * stride + column;
    load_tile<vectors>(target, stride, tile);
    subtract_product<vectors>(matrix + row * stride, stride, packed, column, tile);
    Vector4 result[4][vectors] = {};
    for (int k = 0; k < 4 * vectors; ++k)
      for (int s = 0; s < vectors; ++s) {
        const Vector4 upper = load4(&inverse_upper[k][4 * s]);
        for (int r = 0; r < 4; ++r) result[r][s] += tile[r][k / 4][k % 4] * upper;
      }
    store_tile<vectors>(target, stride, result);
  }
}

/// One strip of 4 * vectors columns starting at `column`; `packed` holds n x 4 vectors doubles.
template <int vectors>
inline bool eliminate_strip(double* matrix, long stride, int num_pivots, int num_rows, int column, double* packed) {
  if (column >= num_pivots) {
    forward_strip<vectors>(matrix, stride, column, num_pivots, packed);
    update_rows<vectors>(matrix, stride, column, {num_pivots, num_rows}, packed, num_pivots);
    return true;
  }
  constexpr int width = 4 * vectors;
  forward_strip<vectors>(matrix, stride, column, column, packed);
  update_rows<vectors>(matrix, stride, column, {column, column + width}, packed, column);
  double inverse_upper[width][width];
  const bool regular = factor_diagonal_block<width>(matrix + column * stride + column, stride, inverse_upper);
  panel_rows<vectors>(matrix, stride, column, {column + width, num_rows}, packed, inverse_upper);
  return regular;
}

/// The whole elimination of a matrix of rows x columns. num_pivots <= rows and columns are multiples of 4. `packed`: 8
/// * num_pivots doubles. Returns false when a pivot vanished or is not finite.
inline bool eliminate_strips(double* matrix, long stride, int num_pivots, int rows, int columns, double* packed) {
  bool regular = true;
  for (int column = 0; column < columns;) {
    const int available = (column < num_pivots ? num_pivots : columns) - column;
    if (available >= 8) {
      regular = eliminate_strip<2>(matrix, stride, num_pivots, rows, column, packed) && regular;
      column += 8;
    } else {
      regular = eliminate_strip<1>(matrix, stride, num_pivots, rows, column, packed) && regular;
      column += 4;
    }
  }
  return regular;
}

}  // namespace tentpole
