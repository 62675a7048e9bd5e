#include <gtest/gtest.h>

#include "bench/sample_patches.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

TEST(RepeatPatches, EveryCopyIsSolvedOnItsOwn) {
  const TentBatch batch = repeat_patches(sample_patches(2, 2, 3, 2), 5);
  ASSERT_EQ(batch.patches.size(), 5u);
  ASSERT_EQ(batch.elements.size(), 15u);
  const TentBatch answer = solved(batch);
  EXPECT_LE(polynomial_error(answer, 15), 1e-10);
}

TEST(PolynomialError, IsNotANumberWhereAnAnswerIsMissing) {
  const TentBatch unsolved = sample_patches(1, 2, 1, 1);
  EXPECT_FALSE(polynomial_error(unsolved, 1) <= 1e300);
}

}  // namespace
}  // namespace tentpole
