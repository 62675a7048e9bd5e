#pragma once

#include <cstdint>
#include <random>

#include "host/front/adaptive_front.hpp"

namespace tentpole::testing {

/// How often each operation was done, and what was seen.
struct OperationCounts {
  std::int64_t tents = 0, inclined = 0, splits = 0, edge_splits = 0, refused = 0, deletions = 0, flips = 0;
  double smallest_rise = 1e300;  ///< of vertical tents, in altitudes / c of the fastest region around
};

/// What random operations may do.
struct OperationMix {
  int max_cells = 400;  ///< no splits beyond
  bool only_tents = false;
  DeletionLimits deletion;
};

/// One random operation: a vertical or inclined tent at a random local minimum, a bisection, a cut of a random edge, a
/// vertex deletion or a flip. `causality` of the front is needed for the measure of rises.
void random_operation(AdaptiveFront& front, std::mt19937_64& random, double causality, const OperationMix& mix,
                      OperationCounts& counts);

/// Gives cells whose centre lies beyond x the region "right" and the others "left".
void divide_into_regions(SpaceMesh& mesh, double x);

/// Marks about every n-th inner edge (D = 1: vertex) as a crack.
void mark_random_cracks(AdaptiveFront& front, std::mt19937_64& random, int n);

/// Smallest angle of all cells [degrees], D = 2.
double smallest_angle(const FrontMesh& mesh);

/// A random number below n.
int draw_below(std::mt19937_64& random, int n);

/// Uniform in (0, 1).
double draw_unit(std::mt19937_64& random);

/// A random cell.
int draw_cell(const FrontMesh& mesh, std::mt19937_64& random);

}  // namespace tentpole::testing
