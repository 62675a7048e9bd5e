#pragma once

#include <vector>

#include "host/many_core/machine.hpp"

namespace tentpole {

/// The matrix of the calibration: degree 7 in three dimensions.
constexpr int calibration_rows = 990;

/// Measures the parameters of the model on the machine at hand, in about two seconds, with the loop of row_update.hpp
/// on a matrix of calibration_rows rows:
///
/// - vector_time from rows that stay in the core's cache;
/// - core_bandwidth from what the whole matrix takes longer, on one core alone;
/// - shared_bandwidth from what its shares take longer on all cores at once, each thread with rows of its own and
///   without forks or joins;
/// - fork and join from loops over one short row per thread, up to the number of cores; `turn` from twice as many;
/// - the caches and cores from the system. Page walks and arrivals are part of the measured times, so they are 0.
///
/// Times are those that one repetition in ten beats, because other programs only ever lengthen them.
Machine calibrate_machine();

/// Measured time of one pass over the same rows on 1..most_threads threads [s], to be held against the model.
std::vector<double> measure_sweep(int most_threads);

}  // namespace tentpole
