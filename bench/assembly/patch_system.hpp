#pragma once

#include "bench/assembly/rungs.hpp"
#include "kernels/reference/patch_matrix.reference.hpp"
#include "tests/kernels/tent_samples.hpp"

namespace tentpole {

/// The linear system of patch 0 of a batch: matrix by quadrature with the double loops of `vectorized` (the same matrix
/// as reference_patch_system to rounding, a test compares them, in a hundredth of its time), right-hand side K c of the
/// batch's polynomial, which the method reproduces exactly.
DensePatch polynomial_patch_system(TentBatch& batch);

/// b = K c with the coefficients of the batch's polynomial on patch 0.
std::vector<double> polynomial_right_side(const TentBatch& batch, const std::vector<double>& matrix);

}  // namespace tentpole
