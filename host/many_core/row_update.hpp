#pragma once

namespace tentpole {

/// The loop that the model is about: a cell matrix gains the contribution of one quadrature point,
///
///   matrix(r, c) += sum_t test(t, r) trial(t, c)          r, c = 0..num_rows-1,  t = 0..num_terms-1.
struct RowUpdate {
  int num_rows = 0;  ///< n
  int num_terms = 0;
  const double* test = nullptr;   ///< (num_terms, n)
  const double* trial = nullptr;  ///< (num_terms, n)
  double* matrix = nullptr;       ///< (n, n)
};

/// Rows first..last-1 on the calling thread.
void update_rows(const RowUpdate& update, int first, int last);

/// All rows on p threads with a static schedule: one fork and one join.
void update_rows_on_threads(const RowUpdate& update, int num_threads);

}  // namespace tentpole
