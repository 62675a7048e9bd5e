#pragma once

#include <vector>

#include "host/batch/host_batch.hpp"
#include "host/output/spacetime_element.hpp"
#include "host/problem/simulation.hpp"

namespace tentpole {

/// An element of a batch in SI units, as everything that writes results sees it; without coefficients.
SpacetimeElement spacetime_element(const Simulation& simulation, const HostBatch& batch, std::int32_t index);

/// Coefficients [m] of the element batch.wanted[index] of a solved batch.
std::vector<double> solved_coefficients(const Simulation& simulation, const HostBatch& batch, std::size_t index);

}  // namespace tentpole
