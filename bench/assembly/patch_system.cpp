#include "bench/assembly/patch_system.hpp"

#include "kernels/element/simd.hpp"

namespace tentpole {

DensePatch polynomial_patch_system(TentBatch& batch) {
  const PatchBatch view = batch.view();
  const PatchDescriptor& patch = batch.patches[0];
  const CellTables tables(batch.dimension, batch.degree);
  DensePatch system;
  system.size = patch.num_elements * tables.num_unknowns;
  system.matrix.assign(static_cast<std::size_t>(system.size) * system.size, 0.0);
  for (int local = 0; local < patch.num_elements; ++local) {
    const int element = patch.first_element + local;
    assemble_updates(ElementUpdates(tables, view, element, true), element, patch.first_element,
                     {system.matrix.data(), system.size}, add_vectorized);
  }
  system.rhs = polynomial_right_side(batch, system.matrix);
  return system;
}

std::vector<double> polynomial_right_side(const TentBatch& batch, const std::vector<double>& matrix) {
  const int size = batch.patches[0].num_elements * batch.num_unknowns();
  const double* exact =
      batch.exact.data() + static_cast<std::size_t>(batch.patches[0].first_element) * batch.num_unknowns();
  std::vector<double> right(size);
  for (long row = 0; row < size; ++row) right[row] = dot(matrix.data() + row * size, exact, size);
  return right;
}

}  // namespace tentpole
