#include "host/many_core/row_update.hpp"

namespace tentpole {
namespace {

void update_row(const RowUpdate& update, int row) {
  const long n = update.num_rows;
  double* entries = update.matrix + row * n;
  for (int term = 0; term < update.num_terms; ++term) {
    const double factor = update.test[term * n + row];
    const double* trial = update.trial + term * n;
#pragma omp simd
    for (long column = 0; column < n; ++column) entries[column] += factor * trial[column];
  }
}

}  // namespace

void update_rows(const RowUpdate& update, int first, int last) {
  for (int row = first; row < last; ++row) update_row(update, row);
}

void update_rows_on_threads(const RowUpdate& update, int num_threads) {
#pragma omp parallel for schedule(static) num_threads(num_threads)
  for (int row = 0; row < update.num_rows; ++row) update_row(update, row);
}

}  // namespace tentpole
