#pragma once

#include <vector>

#include "kernels/element/basis_recurrence.hpp"

namespace tentpole {

/// Quadrature on slices t = const of a spacetime simplex and the recurrence of the basis of their integrands.
///
/// Every edge from a corner on one side of the slice to a corner on the other cuts it, so a slice is the image of a
/// product of two simplices, bilinear in their barycentric coordinates (r, f): segment, triangle, tetrahedron with S =
/// 1 corner on the smaller (slow) side, quad and wedge with S = 2. No shape needs to be cut into simplices: the
/// Jacobian has degree D + 1 - S in r and S - 1 in f, so rules of degree 2 k - 2 plus these are exact. Points come in
/// blocks of 4; padding has weight 0. A plain struct of pointers into one block, in the memory of the device that uses
/// it.
struct SliceTablesView {
  static constexpr int block = 4;  ///< points
  int num_blocks[2];               ///< [S - 1]
  const double* points[2];         ///< [S - 1][block][r_1..r_S, f_1..f_{D + 2 - S}, weight][4]
  BasisRecurrence recurrence;      ///< of the basis of degree k - 1 on the element
};

/// Owns the tables on the host. Built once per run.
class SliceTables {
 public:
  /// Throws std::invalid_argument unless 1 <= dimension <= 3 and 1 <= degree <= max_degree.
  SliceTables(int dimension, int degree);

  /// The whole block, to be copied to a device.
  const std::vector<double>& block() const { return block_; }
  /// Tables at a copy of the block that starts at `base`.
  SliceTablesView view(const double* base) const;
  SliceTablesView view() const { return view(block_.data()); }

 private:
  int degree_;
  int num_blocks_[2];
  std::size_t offset_[3];  ///< points of both shapes, recurrence
  std::vector<double> block_;
};

}  // namespace tentpole
