#pragma once

#include <vector>

#include "kernels/reference/patch_matrix.reference.hpp"
#include "tests/kernels/tent_samples.hpp"

namespace tentpole {

/// Real patches of equal size and the linear system of the first: what every variant of bench_lu solves.
struct PatchSystems {
  /// num_patches patches of num_elements elements.
  PatchSystems(int space_dimension, int degree, int num_elements, int num_patches);

  int dimension, degree, num_elements, num_patches;
  TentBatch batch;
  DensePatch system;             ///< of patch 0
  std::vector<double> scale;     ///< [N], s_a = 1 / sqrt(K_aa)
  std::vector<double> scaled;    ///< [N][N], s_a K_ab s_b
  std::vector<double> solution;  ///< [N] of the system, by the reference (kernels/patch/dense_patch_solve.hpp)
};

/// Errors of a solution c of `systems.system`.
struct SolutionError {
  double residual;    ///< max_a |b - K c|_a s_a / max_a (sum_b |K_ab c_b| + |b_a|) s_a: the normwise backward error
  double difference;  ///< max_a |c - c_reference|_a / s_a over max_a |c_reference|_a / s_a
};
SolutionError solution_error(const PatchSystems& systems, const std::vector<double>& solution);

}  // namespace tentpole
