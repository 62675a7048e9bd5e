#include "kernels/eliminate.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <lapacke.h>

namespace tentpole {
namespace {

/// A condensed system [A P; O^T 0] of n unknowns and R amplitudes in the padded layout, sym(A) positive definite.
struct CondensedSystem {
  CondensedShape shape;
  std::vector<double> matrix;

  double& at(int row, int column) { return matrix[static_cast<long>(row) * shape.stride + column]; }
};

CondensedShape shape_of(int num_unknowns, int num_amplitudes) {
  ReferenceTablesView tables{};
  tables.dimension = 1;
  tables.num_unknowns = num_unknowns;
  tables.num_facet_modes = num_amplitudes;
  return {tables, PatchShape(tables, false), 1};
}

CondensedSystem random_system(int num_unknowns, int num_amplitudes, std::uint32_t seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const CondensedShape shape = shape_of(num_unknowns, num_amplitudes);
  CondensedSystem system{shape, std::vector<double>(shape.matrix_size(), 0.0)};
  std::vector<double> factor(num_unknowns * num_unknowns);
  for (double& entry : factor) entry = uniform(generator);
  for (int i = 0; i < num_unknowns; ++i)
    for (int j = 0; j < num_unknowns; ++j) {
      double sum = i == j ? 0.1 : 0;  // the symmetric part: definite, then a skew part of the same size
      for (int k = 0; k < num_unknowns; ++k)
        sum += factor[i * num_unknowns + k] * factor[j * num_unknowns + k] / num_unknowns;
      const double skew = i == j ? 0 : (i < j ? 1 : -1) * factor[std::min(i, j) * num_unknowns + std::max(i, j)];
      system.at(i, j) = sum + skew;
    }
  for (int i = num_unknowns; i < shape.unknowns_padded; ++i) system.at(i, i) = 1;
  for (int i = 0; i < num_unknowns; ++i)
    for (int m = 0; m < num_amplitudes; ++m) {
      system.at(i, shape.unknowns_padded + m) = uniform(generator);
      system.at(shape.unknowns_padded + m, i) = uniform(generator);
    }
  return system;
}

/// A^-1 B by LAPACK, B [n][columns] row-major.
std::vector<double> lapack_solve(CondensedSystem system, std::vector<double> right, int columns) {
  const int n = system.shape.num_unknowns;
  std::vector<double> a(n * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) a[i * n + j] = system.at(i, j);
  std::vector<lapack_int> pivots(n);
  EXPECT_EQ(LAPACKE_dgesv(LAPACK_ROW_MAJOR, n, columns, a.data(), n, pivots.data(), right.data(), columns), 0);
  return right;
}

enum class Variant { serial, one_lane, three_lanes };

bool eliminate_by(Variant variant, CondensedSystem& system) {
  std::vector<double> packed(8 * system.shape.unknowns_padded);
  if (variant == Variant::serial)
    return eliminate_element(system.shape, system.matrix.data(), packed.data(), SerialLane{});
  bool regular = true;
#pragma omp parallel num_threads(variant == Variant::one_lane ? 1 : 3) reduction(&& : regular)
  regular = eliminate_element(system.shape, system.matrix.data(), packed.data(),
                              TeamLanes{omp_get_thread_num(), omp_get_num_threads()});
  return regular;
}

/// U^-1 L^-1 right with the substitutions of the same variant.
std::vector<double> substitute_by(Variant variant, const CondensedSystem& system, std::vector<double> right) {
  right.resize(system.shape.unknowns_padded, 0.0);
  if (variant == Variant::serial) {
    forward_substitute(system.shape, system.matrix.data(), right.data(), SerialLane{});
    back_substitute(system.shape, system.matrix.data(), right.data(), SerialLane{});
    return right;
  }
#pragma omp parallel num_threads(variant == Variant::one_lane ? 1 : 3)
  {
    const TeamLanes lanes{omp_get_thread_num(), omp_get_num_threads()};
    forward_substitute(system.shape, system.matrix.data(), right.data(), lanes);
    back_substitute(system.shape, system.matrix.data(), right.data(), lanes);
  }
  return right;
}

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

class Elimination : public testing::TestWithParam<Variant> {};

TEST_P(Elimination, CondensesAndSolvesAsLapackDoes) {
  for (const int n : {8, 9, 40, 63, 200})
    for (const int r : {3, 24}) {
      CondensedSystem system = random_system(n, r, n + r);
      std::vector<double> columns(n * r), right(n);
      for (int i = 0; i < n; ++i) {
        right[i] = i % 7 - 3;
        for (int m = 0; m < r; ++m) columns[i * r + m] = system.at(i, system.shape.unknowns_padded + m);
      }
      const std::vector<double> loaded = lapack_solve(system, columns, r), solution = lapack_solve(system, right, 1);
      CondensedSystem eliminated = system;
      ASSERT_TRUE(eliminate_by(GetParam(), eliminated));
      for (int row = 0; row < r; ++row)
        for (int column = 0; column < r; ++column) {
          double expected = 0;
          for (int i = 0; i < n; ++i)
            expected -= system.at(system.shape.unknowns_padded + row, i) * loaded[i * r + column];
          EXPECT_NEAR(eliminated.at(system.shape.unknowns_padded + row, system.shape.unknowns_padded + column),
                      expected, 1e-11 * largest(loaded))
              << "n " << n << " r " << r;
        }
      const std::vector<double> found = substitute_by(GetParam(), eliminated, right);
      for (int i = 0; i < n; ++i) EXPECT_NEAR(found[i], solution[i], 1e-12 * largest(solution)) << "n " << n;
    }
}

TEST_P(Elimination, LeavesThePaddingAnIdentity) {
  CondensedSystem system = random_system(9, 3, 1);
  ASSERT_TRUE(eliminate_by(GetParam(), system));
  for (int row = 9; row < 12; ++row)
    for (int column = 9; column < 12; ++column) EXPECT_EQ(system.at(row, column), row == column ? 1 : 0);
  EXPECT_EQ(system.at(15, 15), 0);
}

TEST_P(Elimination, ReportsPivotsThatVanishOrAreNotFinite) {
  CondensedSystem zero = random_system(40, 12, 2);
  for (int j = 0; j < 40; ++j) zero.at(17, j) = zero.at(j, 17) = 0;
  EXPECT_FALSE(eliminate_by(GetParam(), zero));
  CondensedSystem not_a_number = random_system(40, 12, 2);
  not_a_number.at(20, 20) = std::nan("");
  EXPECT_FALSE(eliminate_by(GetParam(), not_a_number));
}

INSTANTIATE_TEST_SUITE_P(Variants, Elimination,
                         testing::Values(Variant::serial, Variant::one_lane, Variant::three_lanes));

}  // namespace
}  // namespace tentpole
