#include "kernels/launch/patch_solver.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "tests/kernels/dense_comparison.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

double largest_difference(const double* left, const double* right, int n) {
  double largest = 0;
  for (int i = 0; i < n; ++i) largest = std::max(largest, std::fabs(left[i] - right[i]));
  return largest;
}

double largest_value(const double* values, int n) {
  double largest = 0;
  for (int i = 0; i < n; ++i) largest = std::max(largest, std::fabs(values[i]));
  return largest;
}

/// Largest relative difference of the coefficients of all elements from the known polynomial.
double error_against_polynomial(const TentBatch& batch) {
  double error = 0;
  const int n = batch.num_unknowns();
  for (std::size_t e = 0; e < batch.elements.size(); ++e) {
    const double* exact = &batch.exact[e * n];
    const double* found = &batch.coefficients[batch.elements[e].result_slot * n];
    error = std::max(error, largest_difference(exact, found, n) / largest_value(exact, n));
  }
  return error;
}

double largest_residual(const TentBatch& batch) {
  double largest = 0;
  for (const ElementRecord& record : batch.records) {
    EXPECT_EQ(record.status, int(Status::ok)) << status_name(Status(record.status));
    largest = std::max(largest, record.residual);
  }
  return largest;
}

class PatchSolver : public testing::TestWithParam<int> {};

TEST_P(PatchSolver, ReproducesPolynomialsOfItsDegree) {
  const int dimension = GetParam();
  for (int degree = 1; degree <= (dimension == 1 ? 7 : 4); ++degree) {
    TentOptions options;
    options.num_patches = dimension == 3 ? 1 : 8;
    const TentBatch batch = solved(random_tents(dimension, degree, options, 17 + degree));
    EXPECT_LT(error_against_polynomial(batch), 1e-11) << "degree " << degree;
    EXPECT_LT(largest_residual(batch), 1e-12) << "degree " << degree;
  }
}

TEST_P(PatchSolver, EqualsTheDenseSolutionOnSeveralMaterials) {
  const int dimension = GetParam();
  for (int degree = 1; degree <= (dimension == 3 ? 2 : 4); ++degree) {
    TentOptions options;
    options.num_patches = dimension == 3 ? 1 : 4;
    options.num_materials = 3;
    TentBatch batch = solved(random_tents(dimension, degree, options, 5 + degree));
    const DenseComparison comparison = compare_with_dense(batch);
    EXPECT_LT(comparison.coefficients, 1e-11) << "degree " << degree;  // conditions reach 5e5
    EXPECT_LT(comparison.energy, 1e-12) << "degree " << degree;
    EXPECT_LT(largest_residual(batch), 1e-12) << "degree " << degree;
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, PatchSolver, testing::Values(1, 2, 3));

}  // namespace
}  // namespace tentpole
