// The thesis's first step: pointers instead of operators, and what does not depend on the column out of the inner loop.
// Compiled without the compiler's own vectorisation, which the next rung adds.
#include "bench/assembly/rungs.hpp"

namespace tentpole {

void add_sequential(const UpdateRows& update, MatrixView block) {
  const int n = update.num_unknowns;
  for (int row = 0; row < n; ++row) {
    double* entries = block.row(row);
    const double* trial = update.trial_of(row);
    for (int term = 0; term < update.num_terms; ++term, trial += n) {
      const double factor = update.weight * update.test[term * n + row];
      for (int column = 0; column < n; ++column) entries[column] += factor * trial[column];
    }
  }
}

}  // namespace tentpole
