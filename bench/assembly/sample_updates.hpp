#pragma once

#include <vector>

#include "bench/assembly/element_updates.hpp"
#include "tests/kernels/tent_samples.hpp"

namespace tentpole {

/// The thesis's kernel by itself: `count` updates of one n x n matrix, as the points of the vertical facets of a real
/// element make them, in turn. Sizes as in d = 4: D = 3 terms, n = 3 C(k + 4, 4).
class SampleUpdates {
 public:
  SampleUpdates(int space_dimension, int degree, int count);

  int size() const { return static_cast<int>(indices_.size()); }
  int num_unknowns() const { return tables_.num_unknowns; }
  const ElementUpdates& element() const { return updates_; }

  /// Rows of one update, formed at construction; or formed anew in scratch.
  const UpdateRows& rows(int update) const { return rows_[update]; }
  UpdateRows form(int update, double* scratch) const { return updates_.form(indices_[update], scratch); }

  /// Sum of all updates [n][n], by the matrix product of the BLAS.
  const std::vector<double>& expected() const { return expected_; }
  double flops() const;

 private:
  TentBatch batch_;
  CellTables tables_;
  ElementUpdates updates_;
  std::vector<int> indices_;                 ///< of the element's updates
  std::vector<std::vector<double>> memory_;  ///< [update]
  std::vector<UpdateRows> rows_;
  std::vector<double> expected_;
};

/// `count` updates of this degree with D = 3, kept until another degree or count is asked for: the benchmarks of one
/// degree follow each other.
const SampleUpdates& sample_updates(int degree, int count);

}  // namespace tentpole
