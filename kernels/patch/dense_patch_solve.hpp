#pragma once

#include <span>
#include <vector>

#include "common/status.hpp"

namespace tentpole {

/// Memory of solve_dense_patch, kept by the caller so that a sequence of solves does not allocate.
struct DenseSolveScratch {
  std::vector<double> factors;   ///< [N][N], factors of the scaled matrix
  std::vector<double> scale;     ///< [N], 1 / sqrt |K_aa|
  std::vector<double> residual;  ///< [N]
  std::vector<int> pivots;       ///< [N]
};

/// Solves K c = b by pivoted LU (LAPACK dgetrf) after the symmetric diagonal scaling K_ab / sqrt |K_aa K_bb|; one step
/// of iterative refinement follows where the residual is above 1e-14. The fallback of the patch solver and its
/// baseline. Shapes: matrix [N][N] row-major, rhs [N], solution [N]; neither input is changed. relative_residual: max_a
/// |r_a| s_a / max_a (sum_b |K_ab c_b| + |b_a|) s_a with s_a = 1 / sqrt |K_aa|; 0 for b = 0. Status: singular_pivot
/// where a diagonal entry or a pivot vanishes or is not finite; the solution is then undefined.
Status solve_dense_patch(std::span<const double> matrix, std::span<const double> rhs, std::span<double> solution,
                         double& relative_residual, DenseSolveScratch& scratch);

}  // namespace tentpole
