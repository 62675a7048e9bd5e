#include "bench/assembly/matrix_blocks.hpp"

#include <algorithm>

namespace tentpole {

void pack_block(MatrixView block, int n, std::span<double> entries) {
  for (long row = 0; row < n; ++row) std::copy_n(block.row(row), n, entries.data() + row * n);
}

void unpack_block(std::span<const double> entries, int n, MatrixView block) {
  for (long row = 0; row < n; ++row) std::copy_n(entries.data() + row * n, n, block.row(row));
}

}  // namespace tentpole
