// The thesis's second step: the inner loop of `sequential`, and the compiler is told that nothing in it depends on
// anything else.
#include "bench/assembly/rungs.hpp"

namespace tentpole {

void add_vectorized(const UpdateRows& update, MatrixView block) {
  const int n = update.num_unknowns;
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
