// The loop over quadrature points in threads, which the thesis tried and gave up: all points add to the same matrix, so
// that the double loop, which is nearly all of the work, stands in a critical section.
#include "bench/assembly/rungs.hpp"

namespace tentpole {

void assemble_threaded_quadrature(const ElementUpdates& updates, int element, int first_element,
                                  MatrixView patch_matrix, int num_threads) {
#pragma omp parallel num_threads(num_threads)
  {
    std::vector<double> scratch(updates.scratch_size());
#pragma omp for schedule(static)
    for (int update = 0; update < updates.size(); ++update) {
      const UpdateRows rows = updates.form(update, scratch.data());
      const MatrixView block = patch_matrix.block(element - first_element,
                                                  updates.column_element(update) - first_element, rows.num_unknowns);
#pragma omp critical(element_matrix)
      add_vectorized(rows, block);
    }
  }
}

}  // namespace tentpole
