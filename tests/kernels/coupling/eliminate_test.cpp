#include "kernels/coupling/eliminate.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <lapacke.h>

#include "kernels/coupling/triangular_solve.hpp"

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

/// Calls work(lanes) as the variant says.
template <class Work>
void run(Variant variant, Work work) {
  if (variant == Variant::serial) return work(SerialLane{});
#pragma omp parallel num_threads(variant == Variant::one_lane ? 1 : 3)
  work(TeamLanes{omp_get_thread_num(), omp_get_num_threads()});
}

/// Eliminates the systems side by side; returns which are regular.
std::vector<int> eliminate_by(Variant variant, std::vector<CondensedSystem>& systems) {
  std::vector<double> packed(8 * systems[0].shape.unknowns_padded), inverse_upper(16 * systems.size());
  std::vector<int> is_regular(systems.size());
  CondensedShape largest = systems[0].shape;
  for (const CondensedSystem& system : systems)
    if (system.shape.rows > largest.rows) largest = system.shape;
  const auto system_of = [&](int e) {
    return EliminatedSystem{systems[e].matrix.data(), systems[e].shape, &inverse_upper[16 * e], &is_regular[e]};
  };
  run(variant, [&](const auto& lanes) {
    eliminate_elements({0, static_cast<int>(systems.size())}, largest, system_of, packed.data(), lanes);
  });
  return is_regular;
}
bool eliminate_by(Variant variant, CondensedSystem& system) {
  std::vector<CondensedSystem> alone{system};
  const bool is_regular = eliminate_by(variant, alone)[0];
  system = alone[0];
  return is_regular;
}

/// U^-1 L^-1 right with the substitutions of the same variant.
std::vector<double> substitute_by(Variant variant, const CondensedSystem& system, std::vector<double> right) {
  const CondensedShape& shape = system.shape;
  right.resize(shape.unknowns_padded, 0.0);
  const auto system_of = [&](int) { return TriangularSystem{system.matrix.data(), shape.stride, right.data()}; };
  run(variant, [&](const auto& lanes) {
    forward_substitute({0, 1}, shape.unknowns_padded, system_of, lanes);
    back_substitute({0, 1}, shape.unknowns_padded, system_of, lanes);
  });
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
      const CondensedShape& shape = system.shape;
      std::vector<double> columns(n * r), right(n);
      for (int i = 0; i < n; ++i) {
        right[i] = i % 7 - 3;
        system.at(i, shape.right_column()) = right[i];
        for (int m = 0; m < r; ++m) columns[i * r + m] = system.at(i, system.shape.unknowns_padded + m);
      }
      const std::vector<double> loaded = lapack_solve(system, columns, r), solution = lapack_solve(system, right, 1);
      CondensedSystem eliminated = system;
      ASSERT_TRUE(eliminate_by(GetParam(), eliminated));
      for (int row = 0; row < r; ++row) {
        double emitted = 0;
        for (int i = 0; i < n; ++i) emitted -= system.at(shape.unknowns_padded + row, i) * solution[i];
        EXPECT_NEAR(eliminated.at(shape.unknowns_padded + row, shape.right_column()), emitted,
                    1e-11 * largest(solution))
            << "n " << n << " r " << r;
        for (int column = 0; column < r; ++column) {
          double expected = 0;
          for (int i = 0; i < n; ++i) expected -= system.at(shape.unknowns_padded + row, i) * loaded[i * r + column];
          EXPECT_NEAR(eliminated.at(shape.unknowns_padded + row, shape.unknowns_padded + column), expected,
                      1e-11 * largest(loaded))
              << "n " << n << " r " << r;
        }
      }
      const std::vector<double> found = substitute_by(GetParam(), eliminated, right);
      for (int i = 0; i < n; ++i) EXPECT_NEAR(found[i], solution[i], 1e-12 * largest(solution)) << "n " << n;
    }
}

/// The column of the right-hand side is what the forward substitution makes of it.
TEST_P(Elimination, CondensesTheRightHandSideWithTheMatrix) {
  CondensedSystem system = random_system(40, 24, 3);
  std::vector<double> right(system.shape.unknowns_padded, 0.0);
  for (int i = 0; i < 40; ++i) system.at(i, system.shape.right_column()) = right[i] = 1 + i % 5;
  ASSERT_TRUE(eliminate_by(GetParam(), system));
  const auto system_of = [&](int) { return TriangularSystem{system.matrix.data(), system.shape.stride, right.data()}; };
  forward_substitute({0, 1}, system.shape.unknowns_padded, system_of, SerialLane{});
  for (int i = 0; i < 40; ++i) EXPECT_NEAR(system.at(i, system.shape.right_column()), right[i], 1e-12 * largest(right));
}

/// Elements of a patch have different numbers of ports; each is treated as if it were alone.
TEST_P(Elimination, TreatsElementsSideBySideAsAlone) {
  std::vector<CondensedSystem> systems{random_system(40, 24, 4), random_system(40, 12, 5), random_system(40, 0, 6)};
  std::vector<CondensedSystem> alone = systems;
  EXPECT_EQ(eliminate_by(GetParam(), systems), std::vector<int>({1, 1, 1}));
  for (std::size_t e = 0; e < systems.size(); ++e) {
    ASSERT_TRUE(eliminate_by(GetParam(), alone[e]));
    EXPECT_EQ(systems[e].matrix, alone[e].matrix);
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
