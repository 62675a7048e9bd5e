#include "bench/assembly/reference_cell.hpp"

#include <gtest/gtest.h>

#include "bench/assembly/element_updates.hpp"
#include "bench/assembly/rungs.hpp"
#include "bench/checked_answer.hpp"
#include "bench/sample_patches.hpp"
#include "kernels/reference/patch_matrix.reference.hpp"

namespace tentpole {
namespace {

TEST(ReferenceCell, IsTheMatrixOfAPatchOfOneElement) {
  for (const int dimension : {1, 2, 3})
    for (const int degree : {1, 2, 3}) {
      TentBatch batch = sample_patches(dimension, degree, 1, 2);
      const DensePatch expected = reference_patch_system(batch.view(), dimension, degree, 1);
      const std::vector<double> computed = reference_cell_matrix(batch.view(), dimension, degree, 1);
      EXPECT_LE(relative_difference(computed, expected.matrix), 1e-13) << "D = " << dimension << ", k = " << degree;
    }
}

/// The double loops with neighbours, which the ladder's single cells do not have, give whole patch matrices.
TEST(ElementUpdates, AssembleTheMatrixOfAPatch) {
  for (const int dimension : {1, 2, 3}) {
    const int degree = 3, num_elements = 2;
    TentBatch batch = sample_patches(dimension, degree, num_elements, 1);
    const DensePatch expected = reference_patch_system(batch.view(), dimension, degree, 0);
    const CellTables tables(dimension, degree);
    std::vector<double> matrix(expected.matrix.size(), 0.0);
    for (int element = 0; element < num_elements; ++element) {
      const ElementUpdates updates(tables, batch.view(), element, true);
      assemble_updates(updates, element, 0, {matrix.data(), expected.size}, add_sequential);
    }
    EXPECT_LE(relative_difference(matrix, expected.matrix), 1e-13) << "D = " << dimension;
  }
}

}  // namespace
}  // namespace tentpole
