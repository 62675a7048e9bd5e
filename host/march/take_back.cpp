#include "host/march/take_back.hpp"

namespace tentpole {

void take_back(const HostBatch& batch, const SpaceMesh& mesh, Front& front, CellSources& sources) {
  if (batch.cells.empty()) return;
  std::vector<double> times(front.times().begin(), front.times().end());
  // Tents of one batch share no cell, so their order does not matter. A batch whose building broke off may describe an
  // element more than it has cells; the sources of that one are unchanged.
  for (std::size_t e = 0; e < batch.cells.size(); ++e) {
    const ElementDescriptor& element = batch.elements[e];
    const int cell = batch.cells[e];
    sources.slot[cell] = element.source_slot[mesh.dimension + 1];
    sources.facet[cell] = element.source_facet[mesh.dimension + 1];
    times[mesh.cells[cell][element.pole]] = element.corner[element.pole][mesh.dimension];
  }
  front.set_times(times);
}

}  // namespace tentpole
