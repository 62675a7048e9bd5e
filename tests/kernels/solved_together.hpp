#pragma once

#include <vector>

#include "kernels/element/reference_tables.hpp"
#include "tests/kernels/tent_samples.hpp"

namespace tentpole {

/// Scratch for lanes that share a patch, however few they are.
std::vector<double> team_scratch(const ReferenceTables& tables, const TentBatch& batch, int lanes);

/// Solves the batch in host memory by a team of `lanes` threads, as a GPU does with teams of its own: the path that a
/// CPU device never takes, with as many lanes as we like, and open to the thread sanitizer.
TentBatch solved_together(TentBatch batch, int lanes);

}  // namespace tentpole
