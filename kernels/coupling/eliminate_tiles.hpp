#pragma once

#include "kernels/coupling/condensed_element.hpp"
#include "kernels/coupling/matrix_tile.hpp"
#include "kernels/launch/lanes.hpp"

namespace tentpole {

/// Partial LU without pivoting of [A P b; O^T 0 0] of several elements side by side by the lanes of a team:
/// right-looking in blocks of 4 pivots, all 4 x 4 tiles of the rest independent. Who updates the next diagonal block
/// factors it too, so that the lanes meet twice per block of pivots.

/// One element's system while it is eliminated.
struct EliminatedSystem {
  double* matrix;
  CondensedShape shape;
  double* inverse_upper;  ///< [4][4] of the present pivot block
  int* is_regular;        ///< 0 when a pivot vanished or is not finite

  double* at(int row, int column) const { return matrix + static_cast<long>(row) * shape.stride + column; }
};

/// LU of the diagonal block at `first` in place, and the inverse of its U.
inline void factor_pivots(const EliminatedSystem& system, int first) {
  double inverse[4][4];
  if (!factor_diagonal_block<4>(system.at(first, first), system.shape.stride, inverse)) *system.is_regular = 0;
  for (int k = 0; k < 4; ++k) store4(system.inverse_upper + 4 * k, load4(inverse[k]));
}

/// U = L^-1 (tile) right of the pivots.
inline void solve_upper_tile(const EliminatedSystem& system, int first, int column) {
  Vector4 tile[4][1];
  load_tile<1>(system.at(first, column), system.shape.stride, tile);
  for (int r = 1; r < 4; ++r)
    for (int k = 0; k < r; ++k) tile[r][0] -= *system.at(first + r, first + k) * tile[k][0];
  store_tile<1>(system.at(first, column), system.shape.stride, tile);
}

/// L = (tile) U^-1 below the pivots.
inline void solve_lower_tile(const EliminatedSystem& system, int first, int row) {
  Vector4 tile[4][1], result[4][1] = {};
  load_tile<1>(system.at(row, first), system.shape.stride, tile);
  for (int k = 0; k < 4; ++k)
    for (int r = 0; r < 4; ++r) result[r][0] += tile[r][0][k] * load4(system.inverse_upper + 4 * k);
  store_tile<1>(system.at(row, first), system.shape.stride, result);
}

/// The tile at (row, column) loses L U of the pivots.
inline void update_tile(const EliminatedSystem& system, int first, int row, int column) {
  Vector4 tile[4][1];
  load_tile<1>(system.at(row, column), system.shape.stride, tile);
  for (int k = 0; k < 4; ++k) {
    const Vector4 upper = load4(system.at(first + k, column));
    for (int r = 0; r < 4; ++r) tile[r][0] -= *system.at(row + r, first + k) * upper;
  }
  store_tile<1>(system.at(row, column), system.shape.stride, tile);
}

/// system_of(element) returns an EliminatedSystem; all have the pivots of `largest` and at most its rows and columns.
template <class Lanes, class SystemOf>
inline void eliminate_tiles(ElementRange range, const CondensedShape& largest, SystemOf system_of, const Lanes& lanes) {
  const int num_pivots = largest.unknowns_padded;
  share(lanes, range.count, [&](int e) {
    const EliminatedSystem system = system_of(range.first + e);
    *system.is_regular = 1;
    factor_pivots(system, 0);
  });
  lanes.synchronize();
  for (int first = 0; first < num_pivots; first += 4) {
    const int next = first + 4, tiles_right = (largest.columns - next) / 4, tiles_below = (largest.rows - next) / 4;
    share(lanes, range.count, tiles_right + tiles_below, [&](int e) {
      return [=, system = system_of(range.first + e)](int tile) {
        const int column = next + 4 * tile, row = next + 4 * (tile - tiles_right);
        if (tile < tiles_right) {
          if (column < system.shape.columns) solve_upper_tile(system, first, column);
        } else if (row < system.shape.rows) {
          solve_lower_tile(system, first, row);
        }
      };
    });
    lanes.synchronize();
    share(lanes, range.count, tiles_below * tiles_right, [&](int e) {
      return [=, system = system_of(range.first + e)](int tile) {
        const int row = next + 4 * (tile / tiles_right), column = next + 4 * (tile % tiles_right);
        if (row >= system.shape.rows || column >= system.shape.columns) return;
        update_tile(system, first, row, column);
        if (tile == 0 && next < num_pivots) factor_pivots(system, next);
      };
    });
    lanes.synchronize();
  }
}

}  // namespace tentpole
