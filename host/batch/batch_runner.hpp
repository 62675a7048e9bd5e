#pragma once

#include "device/device_buffer.hpp"
#include "device/gather_slots.hpp"
#include "device/stage_timer.hpp"
#include "host/batch/host_batch.hpp"
#include "host/batch/patch_scratch.hpp"
#include "host/problem/simulation.hpp"
#include "kernels/launch/transplant.hpp"

namespace tentpole {

/// Owns everything that lives on the device for the whole run (reference tables, materials, element store, scratch) and
/// runs batches there: up go the descriptors and prescribed data, down come one record per element, energies on history
/// slices and the coefficients that other output asks for. Used by one thread at a time.
class BatchRunner {
 public:
  /// `threads`: 0 for all of the device's.
  BatchRunner(const Simulation& simulation, const Device& device, int threads, StageTimer& timer,
              TrafficCounters& traffic);

  /// Solves all patches of the batch and fills records, energies, slice_energies, wanted_coefficients and
  /// modelled_flops. Patches whose check fails are solved again by pivoted dense LU on the host. Throws
  /// std::runtime_error naming the cell, place and time when that fails too. Patches with fracture facets keep their
  /// status instead: an adaptive run rejects them.
  void run(HostBatch& batch);

  /// Gives elements of the store other simplices (kernels/launch/transplant.hpp); `num_slots`: what the store must
  /// hold.
  void transplant(std::span<const TransplantRequest> requests, std::int32_t num_slots);

  std::int64_t num_fallbacks() const { return num_fallbacks_; }
  int num_threads() const { return shape_.workers; }
  int num_host_threads() const { return num_host_threads_; }  ///< for work beside the device

  /// Rows of the element store, for checkpoints.
  void read_slots(std::span<const std::int32_t> slots, std::vector<double>& coefficients,
                  std::vector<double>& inverse_jacobians);
  void write_slots(std::span<const std::int32_t> slots, std::span<const double> coefficients,
                   std::span<const double> inverse_jacobians);

 private:
  void prepare_memory(const HostBatch& batch);
  void hold_slots(std::int64_t num_slots);
  void upload(const HostBatch& batch);
  void launch();
  void download(HostBatch& batch);
  void repair_failed_patches(HostBatch& batch);
  void compute_energies(HostBatch& batch);
  void compute_slice_energies(HostBatch& batch);
  void gather_wanted(HostBatch& batch);
  PatchBatch device_batch(const HostBatch& batch);

  const Simulation& simulation_;
  Device device_;
  LaunchShape shape_;
  int num_host_threads_;
  StageTimer& timer_;
  TrafficCounters& traffic_;
  ReferenceTables host_tables_;
  SliceTables host_slice_tables_;
  TransplantTables host_transplant_tables_;
  FractureLaw fracture_law_;
  DeviceBuffer<double> tables_;
  DeviceBuffer<double> slice_tables_;
  DeviceBuffer<double> transplant_tables_;
  DeviceBuffer<Material> materials_;
  DeviceBuffer<double> coefficients_;
  DeviceBuffer<double> inverse_jacobians_;
  DeviceBuffer<PatchDescriptor> patches_;
  DeviceBuffer<ElementDescriptor> elements_;
  DeviceBuffer<double> prescribed_;
  DeviceBuffer<ElementRecord> records_;
  DeviceBuffer<FractureFacet> fractures_;
  DeviceBuffer<FractureRecord> fracture_records_;
  DeviceBuffer<TransplantRequest> transplants_;
  DeviceBuffer<SliceRequest> slice_requests_;
  DeviceBuffer<double> slice_energies_;
  PatchScratch scratch_;
  PatchSolverTask task_{};
  SlotTransfer slots_;
  std::int64_t num_fallbacks_ = 0;
};

}  // namespace tentpole
