#include "host/many_core/row_update.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

TEST(RowUpdate, AddsOuterProductsOnAnyNumberOfThreads) {
  constexpr int n = 7;
  std::vector<double> test(2 * n), trial(2 * n);
  for (int i = 0; i < 2 * n; ++i) test[i] = i - 3, trial[i] = 2 * i + 1;
  for (const int threads : {0, 1, 2, 9}) {
    std::vector<double> matrix(n * n, 1.0);
    const RowUpdate update{n, 2, test.data(), trial.data(), matrix.data()};
    if (threads == 0)
      update_rows(update, 0, n);
    else
      update_rows_on_threads(update, threads);
    for (int r = 0; r < n; ++r)
      for (int c = 0; c < n; ++c)
        EXPECT_EQ(matrix[r * n + c], 1 + test[r] * trial[c] + test[n + r] * trial[n + c]) << threads << " threads";
  }
}

}  // namespace
}  // namespace tentpole
