#pragma once

#include <string>

#include "host/batch/host_batch.hpp"
#include "host/problem/simulation.hpp"

namespace tentpole {

/// Where a patch is, for messages: "cell 7, tent at (0.1, 0.2) m, t = 3e-06 s", its first cell and its lowest point.
std::string patch_place(const HostBatch& batch, const PatchDescriptor& patch, const Simulation& simulation);

}  // namespace tentpole
