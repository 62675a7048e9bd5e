#include "tests/kernels/dense_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <lapacke.h>

#include "kernels/patch/dense_patch_solve.hpp"

namespace tentpole {
namespace {

/// x^T K x, in long double: the terms of a difference cancel.
double square_norm(const DensePatch& dense, const std::vector<double>& x) {
  long double sum = 0;
  for (int i = 0; i < dense.size; ++i) {
    long double row = 0;
    for (int j = 0; j < dense.size; ++j) row += static_cast<long double>(dense.matrix[long(i) * dense.size + j]) * x[j];
    sum += x[i] * row;
  }
  return static_cast<double>(sum);
}

double condition_of_scaled(const DensePatch& dense) {
  const int n = dense.size;
  std::vector<double> scaled(dense.matrix);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      scaled[long(i) * n + j] /= std::sqrt(dense.matrix[long(i) * n + i] * dense.matrix[long(j) * n + j]);
  std::vector<lapack_int> pivots(n);
  const double norm = LAPACKE_dlange(LAPACK_COL_MAJOR, '1', n, n, scaled.data(), n);
  double reciprocal = 0;
  LAPACKE_dgetrf(LAPACK_COL_MAJOR, n, n, scaled.data(), n, pivots.data());
  LAPACKE_dgecon(LAPACK_COL_MAJOR, '1', n, scaled.data(), n, norm, &reciprocal);
  return 1 / reciprocal;
}

}  // namespace

DenseComparison compare_with_dense(TentBatch& batch, const std::vector<FrozenFracture>& fractures) {
  DenseComparison result;
  DenseSolveScratch scratch;
  const int n = batch.num_unknowns();
  for (int p = 0; p < int(batch.patches.size()); ++p) {
    const PatchDescriptor& patch = batch.patches[p];
    const DensePatch dense = reference_patch_system(batch.view(), batch.dimension, batch.degree, p, 1, fractures);
    std::vector<double> solution(dense.size), difference(dense.size);
    double residual = 0, largest = 0, scale = 0;
    if (solve_dense_patch(dense.matrix, dense.rhs, solution, residual, scratch) != Status::ok)
      throw std::runtime_error("the dense reference failed");
    for (int i = 0; i < dense.size; ++i) {
      const int slot = batch.elements[patch.first_element + i / n].result_slot;
      const double root = std::sqrt(dense.matrix[long(i) * dense.size + i]);
      difference[i] = batch.coefficients[long(slot) * n + i % n] - solution[i];
      if (std::isnan(difference[i])) throw std::runtime_error("a coefficient is not a number");
      largest = std::max(largest, std::abs(difference[i]) * root);
      scale = std::max(scale, std::abs(solution[i]) * root);
    }
    result.coefficients = std::max(result.coefficients, largest / scale);
    result.energy = std::max(result.energy,
                             std::sqrt(std::max(0.0, square_norm(dense, difference)) / square_norm(dense, solution)));
    result.condition = std::max(result.condition, condition_of_scaled(dense));
  }
  return result;
}

}  // namespace tentpole
