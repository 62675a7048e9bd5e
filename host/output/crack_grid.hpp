#pragma once

#include <span>

#include "host/output/crack_series.hpp"
#include "host/output/vtkhdf_writer.hpp"

namespace tentpole {

/// Throws std::invalid_argument for a segment without points or with too many.
void check_segment(const CrackSegment& segment, int dimension);

/// The grid of fracture edges that is written to cracks_NNNN.vtkhdf, in the order of their numbers and along each edge.
/// D = 1: one VTK vertex each. D = 2: a chain of num_points + 1 lines through end[0], the Gauss points and end[1], so
/// that every value stands where it was computed; an end repeats the nearest one, because a polynomial continued to the
/// end may leave [0, 1]. Chains share no points. Point data damage, opening [m]; cell data edge, mode.
UnstructuredGrid crack_grid(int dimension, double time, std::span<const CrackSegment> segments);

}  // namespace tentpole
