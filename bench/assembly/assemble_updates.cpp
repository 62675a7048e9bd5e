// The loop over quadrature points that the rungs with a double loop share.
#include "bench/assembly/rungs.hpp"

namespace tentpole {

void assemble_updates(const ElementUpdates& updates, int element, int first_element, MatrixView patch_matrix,
                      const AddUpdate& add) {
  std::vector<double> scratch(updates.scratch_size());
  for (int update = 0; update < updates.size(); ++update) {
    const UpdateRows rows = updates.form(update, scratch.data());
    add(rows,
        patch_matrix.block(element - first_element, updates.column_element(update) - first_element, rows.num_unknowns));
  }
}

}  // namespace tentpole
