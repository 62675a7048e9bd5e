#pragma once

#include <string>
#include <vector>

#include "host/output/checkpoint_file.hpp"
#include "host/problem/simulation.hpp"

namespace tentpole {

/// Everything that decides the result files of a run, as key and value under the names of the case file: constants,
/// discretization, materials, loads, output, and checksums of the mesh. Absent is what may change on resuming: title,
/// batch size, checkpoint interval. A boundary condition does not show its expressions, so its load is a checksum of
/// its values at 4096 events of the spacetime box.
std::vector<Setting> result_settings(const Simulation& simulation);

/// What differs first, as "material.all.density is 3690 there and 3700 here"; empty if nothing does.
std::string first_difference(const std::vector<Setting>& there, const std::vector<Setting>& here);

}  // namespace tentpole
