#include <stdexcept>

#include <lapacke.h>

#include "bench/lu/variants.hpp"

namespace tentpole {

void LapackSolve::solve(const PatchSystems& systems, std::vector<double>& solution) {
  const int size = systems.system.size;
  factors_ = systems.scaled;
  pivots_.resize(size);
  solution.resize(size);
  // The rows of the scaled matrix are LAPACK's columns, hence the transposed solve.
  if (LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, size, size, factors_.data(), size, pivots_.data()) != 0)
    throw std::runtime_error("dgetrf met a singular matrix");
  for (int a = 0; a < size; ++a) solution[a] = systems.system.rhs[a] * systems.scale[a];
  LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'T', size, 1, factors_.data(), size, pivots_.data(), solution.data(), size);
  for (int a = 0; a < size; ++a) solution[a] *= systems.scale[a];
}

}  // namespace tentpole
