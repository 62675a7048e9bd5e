#pragma once

#include "kernels/coupling/condensed_element.hpp"
#include "kernels/launch/lanes.hpp"

namespace tentpole {

/// Substitutions with the triangles that the elimination leaves in the first unknowns_padded rows and columns, for the
/// elements of a range side by side, in blocks of 4: when a block is solved, all blocks behind it lose its
/// contribution, and who updates the next block solves it too. One meeting of the lanes per block.
/// system_of(element) returns a TriangularSystem; all have the same number of unknowns.
struct TriangularSystem {
  const double* matrix;
  long stride;
  double* y;  ///< right-hand side, then solution [unknowns_padded]
};

/// y[row .. row + 4) -= block of the matrix at (row, column) times y[column .. column + 4).
inline void subtract_block(const TriangularSystem& system, int row, int column) {
  const double first = system.y[column], second = system.y[column + 1], third = system.y[column + 2],
               fourth = system.y[column + 3];
  for (int r = 0; r < 4; ++r) {
    const double* entries = system.matrix + (row + r) * system.stride + column;
    system.y[row + r] -= (entries[0] * first + entries[1] * second) + (entries[2] * third + entries[3] * fourth);
  }
}

/// y = L^-1 y within one diagonal block.
inline void solve_lower_block(const TriangularSystem& system, int first) {
  double* y = system.y + first;
  const double* block = system.matrix + first * system.stride + first;
  for (int r = 1; r < 4; ++r)
    for (int k = 0; k < r; ++k) y[r] -= block[r * system.stride + k] * y[k];
}

/// y = U^-1 y within one diagonal block.
inline void solve_upper_block(const TriangularSystem& system, int first) {
  double* y = system.y + first;
  const double* block = system.matrix + first * system.stride + first;
  for (int r = 3; r >= 0; --r) {
    for (int k = r + 1; k < 4; ++k) y[r] -= block[r * system.stride + k] * y[k];
    y[r] /= block[r * system.stride + r];
  }
}

/// y = L^-1 y.
template <class Lanes, class SystemOf>
inline void forward_substitute(ElementRange range, int unknowns_padded, SystemOf system_of, const Lanes& lanes) {
  const int num_blocks = unknowns_padded / 4;
  share(lanes, range.count, [&](int e) { solve_lower_block(system_of(range.first + e), 0); });
  lanes.synchronize();
  for (int solved = 0; solved + 1 < num_blocks; ++solved) {
    share(lanes, range.count, num_blocks - solved - 1, [&](int e) {
      return [=, system = system_of(range.first + e)](int behind) {
        const int row = 4 * (solved + 1 + behind);
        subtract_block(system, row, 4 * solved);
        if (behind == 0) solve_lower_block(system, row);
      };
    });
    lanes.synchronize();
  }
}

/// y = U^-1 y.
template <class Lanes, class SystemOf>
inline void back_substitute(ElementRange range, int unknowns_padded, SystemOf system_of, const Lanes& lanes) {
  const int num_blocks = unknowns_padded / 4;
  share(lanes, range.count, [&](int e) { solve_upper_block(system_of(range.first + e), 4 * (num_blocks - 1)); });
  lanes.synchronize();
  for (int solved = num_blocks - 1; solved > 0; --solved) {
    share(lanes, range.count, solved, [&](int e) {
      return [=, system = system_of(range.first + e)](int ahead) {
        const int row = 4 * (solved - 1 - ahead);
        subtract_block(system, row, 4 * solved);
        if (ahead == 0) solve_upper_block(system, row);
      };
    });
    lanes.synchronize();
  }
}

}  // namespace tentpole
