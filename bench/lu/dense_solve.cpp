#include <algorithm>
#include <stdexcept>

#include "bench/lu/variants.hpp"
#include "kernels/coupling/eliminate_strips.hpp"

namespace tentpole {
namespace {

constexpr int block_size = 192;  // of 32 to 384 the fastest at N = 1080

/// LU in place of the first `size` rows and columns, a multiple of 4.
void factor(double* matrix, long stride, int size, double* packed) {
  for (int first = 0; first < size; first += block_size) {
    const int num_pivots = std::min(block_size, size - first), rest = size - first;
    if (!eliminate_strips(matrix + first * (stride + 1), stride, num_pivots, rest, rest, packed))
      throw std::runtime_error("a pivot of the dense patch matrix vanished");
  }
}

/// y = U^-1 L^-1 y
void substitute(const double* matrix, long stride, int size, double* y) {
  for (int row = 1; row < size; ++row) y[row] -= dot(matrix + row * stride, y, row);
  for (int row = size - 1; row >= 0; --row) {
    const double* entries = matrix + row * stride;
    y[row] = (y[row] - dot(entries + row + 1, y + row + 1, size - row - 1)) / entries[row];
  }
}

}  // namespace

void DenseSolve::solve(const PatchSystems& systems, std::vector<double>& solution) {
  const int size = systems.system.size, padded = (size + 3) / 4 * 4;
  const long stride = padded % 32 == 0 ? padded + 4 : padded;  // a power of two would crowd a few cache sets
  matrix_.resize(padded * stride);
  packed_.resize(8 * block_size);
  right_.assign(padded, 0.0);
  for (int row = 0; row < padded; ++row) {
    double* entries = matrix_.data() + row * stride;
    std::fill_n(entries, padded, 0.0);
    if (row < size) {
      std::copy_n(systems.scaled.data() + static_cast<long>(row) * size, size, entries);
      right_[row] = systems.system.rhs[row] * systems.scale[row];
    } else {
      entries[row] = 1;
    }
  }
  factor(matrix_.data(), stride, padded, packed_.data());
  substitute(matrix_.data(), stride, padded, right_.data());
  solution.resize(size);
  for (int row = 0; row < size; ++row) solution[row] = right_[row] * systems.scale[row];
}

}  // namespace tentpole
