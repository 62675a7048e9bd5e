#pragma once

#include <vector>

#include "kernels/element/basis_recurrence.hpp"

namespace tentpole {

/// Quadrature of degree 2 k on the reference element with the basis at its points, and the recurrence to evaluate the
/// basis elsewhere. Points come in blocks of 4; padding has weight 0. A plain struct of pointers into one block, in the
/// memory of the device that uses it.
struct TransplantTablesView {
  static constexpr int block = 4;  ///< points
  int dimension;                   ///< D
  int num_basis;                   ///< n_b
  int num_blocks;
  const double* points;        ///< [block][eta_0..eta_D, weight times phi_0..phi_{n_b - 1}][4]
  BasisRecurrence recurrence;  ///< of the basis of degree k
};

/// Owns the tables on the host. Built once per run.
class TransplantTables {
 public:
  /// Throws std::invalid_argument unless 1 <= dimension <= 3 and 1 <= degree <= max_degree.
  TransplantTables(int dimension, int degree);

  /// The whole block, to be copied to a device.
  const std::vector<double>& block() const { return block_; }
  /// Tables at a copy of the block that starts at `base`.
  TransplantTablesView view(const double* base) const;
  TransplantTablesView view() const { return view(block_.data()); }

 private:
  int dimension_;
  int degree_;
  int num_basis_;
  int num_blocks_;
  std::size_t recurrence_offset_;
  std::vector<double> block_;
};

}  // namespace tentpole
