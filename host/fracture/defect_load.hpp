#pragma once

#include "host/case_file/fracture_settings.hpp"

namespace tentpole {

/// How many defects (or tests) of one cell are generated at a time: about 0.1 s and 100 MB.
inline constexpr double most_defects_per_cell = 1e6;

/// Expected number of defects that are generated when those no stronger than `strongest` [Pa] are wanted in a region of
/// this measure [m^D], D = 1 or 2; of the sampled model, expected number of tests.
double mean_defects_searched(int dimension, const NucleationSettings& nucleation, double measure, double strongest);

}  // namespace tentpole
