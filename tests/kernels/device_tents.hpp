#pragma once

#include "device/device_buffer.hpp"
#include "kernels/launch/patch_solver.hpp"
#include "tests/kernels/tent_samples.hpp"

namespace tentpole {

/// A batch of tents in the memory of a device (or of the host), with the reference tables of its degree.
class DeviceTents {
 public:
  DeviceTents(const TentBatch& batch, const Device& device);

  const Device& device() const { return device_; }
  TrafficCounters& traffic() { return traffic_; }
  PatchBatch view();
  ReferenceTablesView tables() const { return tables_.view(table_block_.pointer()); }

  /// Solves all patches; `shape` as for PatchSolverTask.
  void solve(LaunchShape shape);

  /// Copies what kernels write (coefficients, inverse Jacobians, records) into a batch of the same sizes.
  void download(TentBatch& batch);

 private:
  template <class T>
  DeviceBuffer<T> uploaded(const std::vector<T>& values) {
    DeviceBuffer<T> buffer(device_, traffic_, std::ssize(values));
    if (!values.empty()) buffer.upload(values);
    return buffer;
  }

  Device device_;
  TrafficCounters traffic_;
  ReferenceTables tables_;
  std::vector<PatchDescriptor> host_patches_;
  DeviceBuffer<double> table_block_;
  DeviceBuffer<PatchDescriptor> patches_;
  DeviceBuffer<ElementDescriptor> elements_;
  DeviceBuffer<double> prescribed_;
  DeviceBuffer<Material> materials_;
  DeviceBuffer<double> coefficients_;
  DeviceBuffer<double> inverse_jacobians_;
  DeviceBuffer<ElementRecord> records_;
  FractureLaw fracture_law_;
  DeviceBuffer<FractureFacet> fracture_facets_;
  DeviceBuffer<FractureRecord> fracture_records_;
};

/// The solution of a copy of the batch.
TentBatch solved(TentBatch batch, const Device& device, LaunchShape shape);
/// On the host by one thread.
TentBatch solved(TentBatch batch);

}  // namespace tentpole
