#include <algorithm>
#include <random>

#include <gtest/gtest.h>
#include <lapacke.h>

#include "kernels/element/principal_stress.hpp"

namespace tentpole {
namespace {

template <int D>
double by_lapack(const double (&tensor)[D][D]) {
  double work[D * D], eigenvalues[D];
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) work[i * D + j] = tensor[i][j];
  EXPECT_EQ(LAPACKE_dsyev(LAPACK_ROW_MAJOR, 'N', 'U', D, work, D, eigenvalues), 0);
  return eigenvalues[D - 1];
}

template <int D>
double norm(const double (&tensor)[D][D]) {
  double largest = 0;
  for (const auto& row : tensor)
    for (const double entry : row) largest = std::max(largest, std::abs(entry));
  return largest;
}

template <int D>
void compare_random_tensors() {
  std::mt19937 generator(D);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int sample = 0; sample < 1000; ++sample) {
    double tensor[D][D];
    const double shift = 100 * uniform(generator) * (sample % 3);
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j) tensor[i][j] = tensor[j][i] = uniform(generator) + (i == j ? shift : 0);
    EXPECT_NEAR(largest_principal<D>(tensor), by_lapack<D>(tensor), 1e-14 * norm<D>(tensor));
  }
}

TEST(LargestPrincipal, IsTheLargestEigenvalueOfLapack) {
  compare_random_tensors<1>();
  compare_random_tensors<2>();
  compare_random_tensors<3>();
}

TEST(LargestPrincipal, IsExactForMultiplesOfTheIdentityAndForZero) {
  const double pressure[3][3] = {{-4, 0, 0}, {0, -4, 0}, {0, 0, -4}}, zero[3][3] = {}, plane[2][2] = {{3, 0}, {0, 3}};
  EXPECT_EQ(largest_principal<3>(pressure), -4);
  EXPECT_EQ(largest_principal<3>(zero), 0);
  EXPECT_EQ(largest_principal<2>(plane), 3);
}

/// Twice the same largest or smallest value: the cubic has a double root, where its trigonometric solution is least
/// exact.
TEST(LargestPrincipal, IsFoundAtDoubleEigenvalues) {
  for (const double other : {-5.0, 1.0 - 1e-9, 1.0 + 1e-9, 7.0}) {
    // diag(1, 1, other) turned by 30 degrees about y.
    const double c = std::sqrt(0.75), s = 0.5;
    const double tensor[3][3] = {
        {c * c + s * s * other, 0, c * s * (other - 1)}, {0, 1, 0}, {c * s * (other - 1), 0, s * s + c * c * other}};
    EXPECT_NEAR(largest_principal<3>(tensor), std::max(1.0, other), 1e-7 * norm<3>(tensor)) << other;
    EXPECT_NEAR(largest_principal<3>(tensor), by_lapack<3>(tensor), 1e-7 * norm<3>(tensor)) << other;
  }
}

}  // namespace
}  // namespace tentpole
