#pragma once

#include "host/batch/host_batch.hpp"
#include "host/output/run_summary.hpp"
#include "host/problem/simulation.hpp"

namespace tentpole {

/// A patch may miss its balance by this part of the largest energy, work or loss of one element so far, and a whole run
/// by this part of the largest share of its energy. Sound runs miss it by 1e-10 at most (docs/results.md): what the
/// patch solver leaves is rounding, whatever the mesh, and four million patches add up to 2e-12.
inline constexpr double balance_limit = 1e-6;

/// What a solved patch did with energy.
PatchEnergies patch_energies(const HostBatch& batch, const PatchDescriptor& patch, const Simulation& simulation);

/// Raises `scale` to the largest PatchEnergies::largest of the batch; those that are not finite are left out.
void raise_energy_scale(double& scale, const HostBatch& batch);

/// Whether the energies of solved patch number `patch` are finite, with room for sums over any run, and balance to
/// balance_limit. `scale`: PatchEnergies::largest over all patches so far.
bool is_balanced(const HostBatch& batch, int patch, double scale, const Simulation& simulation);

/// Throws std::runtime_error with place, time and values unless the patch is balanced.
void require_balance(const HostBatch& batch, int patch, double scale, const Simulation& simulation);

/// Throws std::runtime_error with the values unless the energies of a run that has reached its end are finite and
/// balance to balance_limit. `scale` in J per unit of the missing dimensions.
void require_balance(const RunSummary::Energy& energy, double scale);

}  // namespace tentpole
