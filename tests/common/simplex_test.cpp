#include "common/simplex.hpp"

#include <set>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

TEST(Simplex, CountsPolynomialsAsTheThesisDoes) {
  // Thesis 3.3: n = 3 C(k + 4, 4) = 15 .. 990 for k = 1..7.
  const int expected[] = {15, 45, 105, 210, 378, 630, 990};
  for (int degree = 1; degree <= 7; ++degree) EXPECT_EQ(3 * num_polynomials(4, degree), expected[degree - 1]);
  EXPECT_EQ(num_polynomials(3, -1), 0);
  EXPECT_EQ(binomial(5, 6), 0);
  EXPECT_EQ(binomial(5, -1), 0);
}

TEST(Simplex, NumbersEverySymmetricComponentOnce) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    std::set<int> indices;
    for (int i = 0; i < dimension; ++i)
      for (int j = i; j < dimension; ++j) {
        indices.insert(symmetric_index(dimension, i, j));
        EXPECT_EQ(symmetric_index(dimension, i, j), symmetric_index(dimension, j, i));
      }
    EXPECT_EQ(static_cast<int>(indices.size()), num_symmetric(dimension));
    EXPECT_EQ(*indices.rbegin(), num_symmetric(dimension) - 1);
  }
  EXPECT_EQ(symmetric_index(3, 0, 1), 3);
  EXPECT_EQ(symmetric_index(3, 1, 2), 4);
  EXPECT_EQ(symmetric_index(3, 0, 2), 5);
}

}  // namespace
}  // namespace tentpole
