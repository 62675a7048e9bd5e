#pragma once

#include <vector>

#include "kernels/element/patch_batch.hpp"

namespace tentpole {

/// Matrix [n][n] of a batch's element number `element`, whose vertical sides are absorbing boundaries: the truth that
/// every rung of the ladder is compared with. The terms of kernels/reference/patch_matrix.reference.hpp, point by point
/// from the definitions with rules of degree 2 k, kappa = 1; only their sum goes through the matrix product of the
/// BLAS, because reference_patch_system takes minutes at n = 990. A test compares the two.
std::vector<double> reference_cell_matrix(const PatchBatch& batch, int space_dimension, int degree, int element);

}  // namespace tentpole
