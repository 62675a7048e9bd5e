#pragma once

#include "kernels/coupling/eliminate_strips.hpp"
#include "kernels/coupling/eliminate_tiles.hpp"

namespace tentpole {

/// Partial LU without pivoting of [A P b; O^T 0 0] (kernels/coupling/condensed_element.hpp) of the elements of a range:
/// the first unknowns_padded columns are eliminated in place. Afterwards A holds L (unit lower) and U, P holds L^-1 P,
/// O^T holds O^T U^-1, the column of b holds L^-1 b above and -O^T A^-1 b below, and the block between holds -O^T A^-1
/// P, minus the response T of the outgoing amplitudes to the incoming ones. No pivoting is needed in any order because
/// sym(A) is positive semidefinite (docs/formulation.md, The patch matrix): growth <= 2. Flops: 2/3 n^3 + 2 n^2 R + 2 n
/// R^2. A thread that is alone takes columns in strips, lanes of a team take tiles. `packed`: 8 * unknowns_padded
/// doubles.
template <class Lanes, class SystemOf>
inline void eliminate_elements(ElementRange range, const CondensedShape& largest, SystemOf system_of, double* packed,
                               const Lanes& lanes) {
  if constexpr (Lanes::cooperative) {
    eliminate_tiles(range, largest, system_of, lanes);
  } else {
    for (int e = 0; e < range.count; ++e) {
      const EliminatedSystem system = system_of(range.first + e);
      const CondensedShape& shape = system.shape;
      *system.is_regular =
          eliminate_strips(system.matrix, shape.stride, shape.unknowns_padded, shape.rows, shape.columns, packed);
    }
  }
}

}  // namespace tentpole
