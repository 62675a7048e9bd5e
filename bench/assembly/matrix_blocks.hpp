#pragma once

#include <span>

#include "bench/assembly/rungs.hpp"

namespace tentpole {

/// Copies an n x n block of a larger matrix to contiguous memory [n][n], and back.
void pack_block(MatrixView block, int n, std::span<double> entries);
void unpack_block(std::span<const double> entries, int n, MatrixView block);

}  // namespace tentpole
