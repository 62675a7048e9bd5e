#pragma once

#include <vector>

#include "host/batch/element_store.hpp"
#include "host/batch/host_batch.hpp"
#include "host/front/front.hpp"
#include "host/problem/prescribed_data.hpp"
#include "host/problem/simulation.hpp"

namespace tentpole {

/// What lies below each cell of the front.
struct CellSources {
  std::vector<std::int32_t> slot;   ///< [cell]: element store slot, or none: the initial data
  std::vector<std::int32_t> facet;  ///< [cell]: facet_table() of that element's outflow facet which is the cell
};

/// Erects tents on local minima of the front and describes them as patches of a batch. The front and the sources
/// advance at once: batches run in the order they were built.
class BatchBuilder {
 public:
  BatchBuilder(const Simulation& simulation, Front& front, CellSources& sources, ElementStore& store);

  /// Fills `batch` with tents on up to `max_patches` local minima below the end time; empty when none is left.
  void build(HostBatch& batch, int max_patches);

 private:
  void add_tent(HostBatch& batch, int vertex, double top_time);
  void describe_cell(HostBatch& batch, const CellCorner& pole, double top_time);
  void describe_inflow(HostBatch& batch, ElementDescriptor& element, int cell);
  void describe_facets(HostBatch& batch, ElementDescriptor& element, int cell);

  const Simulation& simulation_;
  Front& front_;
  CellSources& sources_;
  ElementStore& store_;
  PrescribedData prescribed_;
  std::vector<std::int32_t>
      element_of_cell_;  ///< [cell]: element of the patch at hand, valid for the cells of its star
};

}  // namespace tentpole
