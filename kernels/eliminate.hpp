#pragma once

#include "kernels/condensed_element.hpp"
#include "kernels/lanes.hpp"
#include "kernels/simd.hpp"

namespace tentpole {

/// Partial LU without pivoting of [A P; O^T 0]: the first n columns are eliminated in place. Afterwards A holds L (unit
/// lower) and U, P holds L^-1 P, O^T holds O^T U^-1, and the lower right block holds -O^T A^-1 P, minus the response T
/// of the outgoing amplitudes to the incoming ones. No pivoting is needed in any order because sym(A) is positive
/// semidefinite (docs/formulation.md, The patch matrix): growth <= 2. Left-looking by column strips of 8 or 4: a strip
/// is packed, and every 4 x 8 tile meets all its updates in registers. Flops: 2/3 n^3 + 2 n^2 R + 2 n R^2.

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

/// Rows from `first` on lose the contribution of the packed rows 0..length.
template <int vectors>
inline void update_rows(double* matrix, long stride, int column, int first, int last, const double* packed,
                        int length) {
  for (int row = first; row < last; row += 4) {
    Vector4 tile[4][vectors];
    load_tile<vectors>(matrix + row * stride + column, stride, tile);
    subtract_product<vectors>(matrix + row * stride, stride, packed, length, tile);
    store_tile<vectors>(matrix + row * stride + column, stride, tile);
  }
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

/// Rows below the diagonal block: update, then L = C U^-1.
template <int vectors>
inline void panel_rows(double* matrix, long stride, int column, int first, int last, const double* packed,
                       const double (&inverse_upper)[4 * vectors][4 * vectors]) {
  for (int row = first; row < last; row += 4) {
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
    update_rows<vectors>(matrix, stride, column, num_pivots, num_rows, packed, num_pivots);
    return true;
  }
  constexpr int width = 4 * vectors;
  forward_strip<vectors>(matrix, stride, column, column, packed);
  update_rows<vectors>(matrix, stride, column, column, column + width, packed, column);
  double inverse_upper[width][width];
  const bool regular = factor_diagonal_block<width>(matrix + column * stride + column, stride, inverse_upper);
  panel_rows<vectors>(matrix, stride, column, column + width, num_rows, packed, inverse_upper);
  return regular;
}

/// The whole elimination by one thread. num_pivots and rows are multiples of 4. `packed`: 8 * num_pivots doubles.
/// Returns false when a pivot vanished or is not finite.
inline bool eliminate(double* matrix, long stride, int num_pivots, int rows, double* packed) {
  bool regular = true;
  for (int column = 0; column < rows;) {
    const int available = (column < num_pivots ? num_pivots : rows) - column;
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

/// The same elimination by the lanes of a team, right-looking in blocks of 4: after each block of pivots all
/// 4 x 4 tiles of the rest are updated independently.
template <class Lanes>
inline bool eliminate_together(double* matrix, long stride, int num_pivots, int rows, const Lanes& lanes) {
  bool regular = true;
  for (int column = 0; column < num_pivots; column += 4) {
    double upper_inverse[4][4], block[16];
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) block[4 * i + j] = matrix[(column + i) * stride + column + j];
    regular = factor_diagonal_block<4>(block, 4, upper_inverse) && regular;
    const int rest = (rows - column) / 4 - 1;
    lanes.synchronize();
    for (int tile = lanes.first(); tile < 2 * rest + 1; tile += lanes.count()) {
      if (tile == 2 * rest) {
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j < 4; ++j) matrix[(column + i) * stride + column + j] = block[4 * i + j];
      } else if (tile < rest) {
        Vector4 sum[4][1];
        double* target = matrix + column * stride + column + 4 + 4 * tile;
        load_tile<1>(target, stride, sum);
        for (int r = 1; r < 4; ++r)
          for (int k = 0; k < r; ++k) sum[r][0] -= block[4 * r + k] * sum[k][0];
        store_tile<1>(target, stride, sum);
      } else {
        Vector4 sum[4][1], result[4][1] = {};
        double* target = matrix + (column + 4 + 4 * (tile - rest)) * stride + column;
        load_tile<1>(target, stride, sum);
        for (int k = 0; k < 4; ++k)
          for (int r = 0; r < 4; ++r) result[r][0] += sum[r][0][k] * load4(upper_inverse[k]);
        store_tile<1>(target, stride, result);
      }
    }
    lanes.synchronize();
    for (int tile = lanes.first(); tile < rest * rest; tile += lanes.count()) {
      const int row = column + 4 + 4 * (tile / rest), other = column + 4 + 4 * (tile % rest);
      Vector4 sum[4][1];
      load_tile<1>(matrix + row * stride + other, stride, sum);
      for (int k = 0; k < 4; ++k)
        for (int r = 0; r < 4; ++r)
          sum[r][0] -= matrix[(row + r) * stride + column + k] * load4(matrix + (column + k) * stride + other);
      store_tile<1>(matrix + row * stride + other, stride, sum);
    }
    lanes.synchronize();
  }
  return regular;
}

template <class Lanes>
inline bool eliminate_element(const CondensedShape& shape, double* matrix, double* packed, const Lanes& lanes) {
  if constexpr (Lanes::cooperative) {
    return eliminate_together(matrix, shape.stride, shape.unknowns_padded, shape.rows, lanes);
  } else {
    return eliminate(matrix, shape.stride, shape.unknowns_padded, shape.rows, packed);
  }
}

/// y = L^-1 y in place; y has unknowns_padded entries.
template <class Lanes>
inline void forward_substitute(const CondensedShape& shape, const double* matrix, double* y, const Lanes& lanes) {
  if constexpr (Lanes::cooperative) {
    for (int column = 0; column < shape.unknowns_padded; ++column) {
      for (int row = column + 1 + lanes.first(); row < shape.unknowns_padded; row += lanes.count())
        y[row] -= matrix[static_cast<long>(row) * shape.stride + column] * y[column];
      lanes.synchronize();
    }
  } else {
    for (int row = 1; row < shape.unknowns_padded; ++row)
      y[row] -= dot(matrix + static_cast<long>(row) * shape.stride, y, row);
  }
}

/// y = U^-1 y in place.
template <class Lanes>
inline void back_substitute(const CondensedShape& shape, const double* matrix, double* y, const Lanes& lanes) {
  const int n = shape.unknowns_padded;
  if constexpr (Lanes::cooperative) {
    for (int column = n - 1; column >= 0; --column) {
      if (lanes.first() == 0) y[column] /= matrix[static_cast<long>(column) * shape.stride + column];
      lanes.synchronize();
      for (int row = lanes.first(); row < column; row += lanes.count())
        y[row] -= matrix[static_cast<long>(row) * shape.stride + column] * y[column];
      lanes.synchronize();
    }
  } else {
    for (int row = n - 1; row >= 0; --row) {
      const double* entries = matrix + static_cast<long>(row) * shape.stride;
      y[row] = (y[row] - dot(entries + row + 1, y + row + 1, n - row - 1)) / entries[row];
    }
  }
}

}  // namespace tentpole
