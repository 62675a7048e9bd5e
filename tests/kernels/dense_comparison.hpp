#pragma once

#include "kernels/reference/patch_matrix.reference.hpp"
#include "tests/kernels/tent_samples.hpp"

namespace tentpole {

/// Distances between the coefficients in a batch's store and the pivoted dense solution of the reference matrix K, the
/// largest over the patches. Scaled norms weigh unknown i with sqrt(K_ii).
struct DenseComparison {
  double coefficients = 0;  ///< largest scaled difference / largest scaled coefficient
  double energy = 0;        ///< sqrt(e^T K e / c^T K c), e the difference: the norm that the method itself controls
  double condition = 0;     ///< estimate for the scaled matrix, infinity norm
};
/// fractures: of every fracture facet of the batch.
DenseComparison compare_with_dense(TentBatch& batch, const std::vector<FrozenFracture>& fractures = {});

}  // namespace tentpole
