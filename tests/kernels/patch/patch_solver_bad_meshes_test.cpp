#include <random>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "tests/kernels/dense_comparison.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

/// Tents whose matrices are close to singular. No solver can then find the coefficients to better than some unit
/// roundoffs times the condition (1e3 to 1e9 here), because the matrix itself is rounded: ours and the dense reference,
/// which assembles by quadrature, differ by 0.04 to 0.5 of roundoff times condition, and where it matters ours is the
/// closer one to the exact polynomial, by a factor of up to 8. The equations are satisfied to rounding all the same.
constexpr double roundoff = 2.3e-16;

/// D = 3: one patch, at the boundary and of four elements, so that the dense solution stays quick.
TentBatch small_patch(int degree, const StarShape& shape, double height_fraction) {
  std::mt19937 generator(77 + degree);
  TentBatch batch;
  batch.dimension = 3;
  batch.degree = degree;
  batch.materials = {random_material(generator)};
  TentGeometry tent;
  do tent = random_star(3, true, shape, generator);
  while (tent.cells.size() > 4);
  const std::vector<double> wave_speed(tent.cells.size(), batch.materials[0].dilatational_speed());
  raise_tent(tent, wave_speed, 0.6, height_fraction, generator);
  append_tent(batch, tent, std::vector<int>(tent.cells.size(), 0), {PolynomialField::random(3, degree, generator)}, {},
              generator);
  return batch;
}

TentBatch bad_tents(int dimension, int degree, const StarShape& shape, double height_fraction) {
  if (dimension == 3) return solved(small_patch(degree, shape, height_fraction));
  TentOptions options;
  options.num_patches = 2;
  options.shape = shape;
  options.height_fraction = height_fraction;
  return solved(random_tents(dimension, degree, options, 77 + degree));
}

void expect_solved_equations(const TentBatch& batch) {
  for (const ElementRecord& record : batch.records) {
    EXPECT_EQ(record.status, int(Status::ok)) << status_name(Status(record.status));
    EXPECT_LT(record.residual, 2e-14);
  }
}

DenseComparison expect_dense_solution(TentBatch batch) {
  expect_solved_equations(batch);
  const DenseComparison comparison = compare_with_dense(batch);
  EXPECT_LT(comparison.coefficients, 4 * roundoff * comparison.condition + 1e-14)
      << "D " << batch.dimension << " k " << batch.degree << " condition " << comparison.condition;
  return comparison;
}

int highest_degree(int dimension) {
  return dimension == 1 ? 7 : (dimension == 2 ? 6 : 4);
}

class BadMesh : public testing::TestWithParam<int> {};

/// Angles do not exist for D = 1; the stars of D = 3 are jittered cubes. In energy the solution is exact to 1e-12 all
/// the same.
TEST_P(BadMesh, WithAnglesFrom5To150DegreesIsSolvedInEnergyTo12Digits) {
  for (int degree = 1; degree <= highest_degree(GetParam()); ++degree) {
    const DenseComparison comparison = expect_dense_solution(bad_tents(GetParam(), degree, {5, 150, 1}, 0.9));
    EXPECT_LT(comparison.energy, 1e-12) << "degree " << degree;
  }
}

TEST_P(BadMesh, WithTentsOfOnePercentHeightIsSolvedAsFarAsItsConditionAllows) {
  for (int degree = 1; degree <= highest_degree(GetParam()); degree += GetParam())
    expect_dense_solution(bad_tents(GetParam(), degree, {}, 0.01));
}

INSTANTIATE_TEST_SUITE_P(Dimensions, BadMesh, testing::Values(1, 2, 3));

TEST(BadMesh, OfSliversIsSolvedAsFarAsItsConditionAllows) {
  for (int degree = 1; degree <= 3; ++degree) expect_dense_solution(bad_tents(3, degree, {20, 130, 0.05}, 0.9));
}

TEST(BadMesh, OfEverythingAtOnceIsSolvedAsFarAsItsConditionAllows) {
  for (const int dimension : {2, 3})
    for (int degree = 1; degree <= (dimension == 2 ? 4 : 2); ++degree)
      expect_dense_solution(bad_tents(dimension, degree, {5, 150, 0.05}, 0.01));
}

}  // namespace
}  // namespace tentpole
