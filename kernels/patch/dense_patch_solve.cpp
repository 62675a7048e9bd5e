#include "kernels/patch/dense_patch_solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <lapacke.h>

namespace tentpole {
namespace {

/// r = b - K c in scaled rows, and its size relative to the terms it is the difference of.
double scaled_residual(std::span<const double> matrix, std::span<const double> rhs, std::span<const double> solution,
                       std::span<const double> scale, std::span<double> residual) {
  const std::size_t size = rhs.size();
  double largest = 0, largest_terms = 0;
  for (std::size_t a = 0; a < size; ++a) {
    double sum = rhs[a], terms = std::abs(rhs[a]);
    for (std::size_t b = 0; b < size; ++b) {
      const double term = matrix[a * size + b] * solution[b];
      sum -= term;
      terms += std::abs(term);
    }
    residual[a] = sum * scale[a];
    largest = std::max(largest, std::abs(residual[a]));
    largest_terms = std::max(largest_terms, terms * scale[a]);
  }
  return largest_terms > 0 ? largest / largest_terms : 0;
}

/// factors = P L U of the transpose of the scaled matrix: its rows are LAPACK's columns.
Status factor(std::span<const double> matrix, DenseSolveScratch& scratch) {
  const std::size_t size = scratch.scale.size();
  for (std::size_t a = 0; a < size; ++a) {
    scratch.scale[a] = 1 / std::sqrt(std::abs(matrix[a * size + a]));
    if (!std::isfinite(scratch.scale[a])) return Status::singular_pivot;
  }
  for (std::size_t a = 0; a < size; ++a)
    for (std::size_t b = 0; b < size; ++b)
      scratch.factors[a * size + b] = matrix[a * size + b] * scratch.scale[a] * scratch.scale[b];
  const int n = static_cast<int>(size);
  const int info = LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, n, n, scratch.factors.data(), n, scratch.pivots.data());
  if (info != 0) return Status::singular_pivot;
  // LAPACK lets a NaN pass: a pivot that is not finite is one that vanished or a matrix that was not finite.
  for (std::size_t a = 0; a < size; ++a)
    if (!std::isfinite(scratch.factors[a * size + a])) return Status::singular_pivot;
  return Status::ok;
}

/// correction = diag(scale) K_scaled^-1 correction
void apply_inverse(const DenseSolveScratch& scratch, std::span<double> correction) {
  const int n = static_cast<int>(correction.size());
  LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'T', n, 1, scratch.factors.data(), n, scratch.pivots.data(), correction.data(),
                      n);
  for (int a = 0; a < n; ++a) correction[a] *= scratch.scale[a];
}

}  // namespace

Status solve_dense_patch(std::span<const double> matrix, std::span<const double> rhs, std::span<double> solution,
                         double& relative_residual, DenseSolveScratch& scratch) {
  const std::size_t size = rhs.size();
  constexpr double refine_above = 1e-14;
  relative_residual = std::numeric_limits<double>::infinity();
  scratch.scale.resize(size);
  scratch.residual.resize(size);
  scratch.pivots.resize(size);
  scratch.factors.resize(size * size);
  if (const Status status = factor(matrix, scratch); status != Status::ok) return status;

  for (std::size_t a = 0; a < size; ++a) solution[a] = rhs[a] * scratch.scale[a];
  apply_inverse(scratch, solution);
  relative_residual = scaled_residual(matrix, rhs, solution, scratch.scale, scratch.residual);
  if (relative_residual > refine_above) {
    apply_inverse(scratch, scratch.residual);
    for (std::size_t a = 0; a < size; ++a) solution[a] += scratch.residual[a];
    relative_residual = scaled_residual(matrix, rhs, solution, scratch.scale, scratch.residual);
  }
  return std::isfinite(relative_residual) ? Status::ok : Status::singular_pivot;
}

}  // namespace tentpole
