#pragma once

#include "host/problem/simulation.hpp"

namespace tentpole {

/// The work that a case asks for must have an end: the tents up to the end time, the sizes that cells may get by
/// refinement, and the defects that are searched in one cell. Throws InputError with the estimates where one is beyond
/// what any machine can do.
void check_workload(const Simulation& simulation);

}  // namespace tentpole
