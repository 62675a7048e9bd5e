#pragma once

#include "host/batch/host_batch.hpp"
#include "host/march/plan_patch.hpp"
#include "host/problem/prescribed_data.hpp"

namespace tentpole {

/// Writes planned patches into a batch: elements, data of boundary and initial front, fracture facets. Acquires a
/// result slot per element; sources and front stay as they are until the patch is accepted.
class PatchWriter {
 public:
  explicit PatchWriter(AdaptiveState& state) : state_(state), prescribed_(state.books.simulation) {}

  void write(const PatchPlan& plan, HostBatch& batch);

 private:
  void write_tent(const PatchPlan& plan, HostBatch& batch);
  void write_tent_facets(const PatchPlan& plan, HostBatch& batch, std::int32_t cell, ElementDescriptor& element);
  void write_exchange(const CellExchange& exchange, HostBatch& batch);
  std::int32_t write_exchange_facets(const CellExchange& exchange, std::size_t first, std::size_t number,
                                     HostBatch& batch, ElementDescriptor& element);
  void write_inflow(HostBatch& batch, ElementDescriptor& element, int facet, std::int32_t cell);
  void write_boundary(HostBatch& batch, ElementDescriptor& element, int facet, int boundary);
  void write_fracture(HostBatch& batch, int facet, std::int32_t element, std::int32_t neighbor, int neighbor_facet,
                      std::int32_t crack_edge, std::int32_t vertex);
  void put_corner(ElementDescriptor& element, int corner, const Point& position, double time) const;
  void finish(HostBatch& batch, ElementDescriptor& element, std::int32_t cell);

  AdaptiveState& state_;
  PrescribedData prescribed_;
};

}  // namespace tentpole
