#pragma once

namespace tentpole {

/// Largest number of space dimensions and largest polynomial degree.
inline constexpr int max_dimension = 3;
inline constexpr int max_degree = 7;

/// Binomial coefficient C(n, k); 0 for k < 0 or k > n.
constexpr int binomial(int n, int k) {
  if (k < 0 || k > n) return 0;
  int result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

/// Number of polynomials of total degree <= degree in `dimension` variables: C(degree + dimension, dimension).
constexpr int num_polynomials(int dimension, int degree) {
  return degree < 0 ? 0 : binomial(degree + dimension, dimension);
}

/// Number of independent components of a symmetric tensor: D (D + 1) / 2.
constexpr int num_symmetric(int dimension) {
  return dimension * (dimension + 1) / 2;
}

/// Index of the component (i, j) of a symmetric tensor in the order xx, yy, zz, xy, yz, xz (those the dimension has).
constexpr int symmetric_index(int dimension, int i, int j) {
  if (i == j) return i;
  if (dimension == 2) return 2;
  return i + j == 1 ? 3 : (i + j == 3 ? 4 : 5);
}

}  // namespace tentpole
