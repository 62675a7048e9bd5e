// The thesis's third step: the outer loop of `vectorized` over threads, one fork and join for every quadrature point.
#include "bench/assembly/rungs.hpp"

namespace tentpole {

void add_threaded_rows(const UpdateRows& update, MatrixView block, int num_threads) {
  const int n = update.num_unknowns;
#pragma omp parallel for schedule(static) num_threads(num_threads)
  for (int row = 0; row < n; ++row) {
    double* entries = block.row(row);
    const double* trial = update.trial_of(row);
    for (int term = 0; term < update.num_terms; ++term, trial += n) {
      const double factor = update.weight * update.test[term * n + row];
#pragma omp simd
      for (int column = 0; column < n; ++column) entries[column] += factor * trial[column];
    }
  }
}

}  // namespace tentpole
