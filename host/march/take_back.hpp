#pragma once

#include "host/march/batch_builder.hpp"

namespace tentpole {

/// Undoes BatchBuilder::build for a batch that will not be committed: front and sources are again what they were before
/// it. Batches are taken back in the reverse of the order they were built in. The elements that the sources then name
/// are still in the store, because their slots go to batches that are built, and so run, later; but the store has given
/// the slots away, so no further batch may be built: this serves the checkpoint of a run that failed.
void take_back(const HostBatch& batch, const SpaceMesh& mesh, Front& front, CellSources& sources);

}  // namespace tentpole
