// Where the thesis began: vectors and matrices of a library whose element access checks its bounds, and a double loop
// that reads as the formula does, with all factors inside.
#include <stdexcept>
#include <vector>

#include "bench/assembly/rungs.hpp"

namespace tentpole {
namespace {

class CheckedMatrix {
 public:
  CheckedMatrix(double* entries, long num_rows, long num_columns, long stride)
      : entries_(entries), num_rows_(num_rows), num_columns_(num_columns), stride_(stride) {}

  double& operator()(long row, long column) const {
    if (row < 0 || row >= num_rows_ || column < 0 || column >= num_columns_)
      throw std::out_of_range("matrix entry outside its bounds");
    return entries_[row * stride_ + column];
  }

 private:
  double* entries_;
  long num_rows_, num_columns_, stride_;
};

/// Value of one term of the test functions at the point.
class TestFunction {
 public:
  explicit TestFunction(const UpdateRows& update)
      : values_(update.test, update.test + static_cast<long>(update.num_terms) * update.num_unknowns),
        num_unknowns_(update.num_unknowns) {}
  double operator()(int term, int row) const {
    return values_.at(static_cast<std::size_t>(term) * num_unknowns_ + row);
  }

 private:
  std::vector<double> values_;
  int num_unknowns_;
};

/// Value of one term of the differential operator applied to the trial functions, as component i of a test meets it.
class TrialOperator {
 public:
  explicit TrialOperator(const UpdateRows& update) : num_basis_(update.num_basis), num_terms_(update.num_terms) {
    for (int row = 0; row < update.num_unknowns; row += num_basis_) {
      const double* values = update.trial_of(row);
      for (long term = 0; term < update.num_terms; ++term)
        components_.push_back({values + term * update.num_unknowns, values + (term + 1) * update.num_unknowns});
    }
  }
  double operator()(int term, int row, int column) const {
    return components_.at(static_cast<std::size_t>(row / num_basis_) * num_terms_ + term).at(column);
  }

 private:
  std::vector<std::vector<double>> components_;  ///< [i][t][column]
  int num_basis_, num_terms_;
};

}  // namespace

void add_with_library_operators(const UpdateRows& update, MatrixView block) {
  const int n = update.num_unknowns;
  const CheckedMatrix matrix(block.entries, n, n, block.stride);
  const TestFunction test(update);
  const TrialOperator trial(update);
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column)
      for (int term = 0; term < update.num_terms; ++term)
        matrix(row, column) += update.weight * test(term, row) * trial(term, row, column);
}

}  // namespace tentpole
