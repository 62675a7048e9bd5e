#pragma once

#include "kernels/element/patch_batch.hpp"
#include "kernels/element/reference_tables.hpp"
#include "kernels/element/slice_tables.hpp"
#include "kernels/launch/launch.hpp"

namespace tentpole {

/// Asks for the energies of one element on the slice t = time.
struct SliceRequest {
  std::int32_t element;  ///< in the batch
  double time;           ///< scaled, within the element's time range
};

/// Everything one launch needs; all pointers in the memory of the device that runs it.
struct SliceEnergyTask {
  PatchBatch batch;  ///< of solved patches: elements, materials and the element store are read
  ReferenceTablesView tables;
  SliceTablesView slice_tables;
  int num_requests;
  const SliceRequest* requests;  ///< [num_requests]; requests of one element follow each other and share work
  double* energies;              ///< [num_requests][2]: kinetic int 1/2 rho v.v, strain int 1/2 sigma:E, scaled
  LaunchShape shape;
};

/// Energies of the displacement polynomials on the slices, exact but for rounding (degree 2 k - 2 on straight slices).
/// A corner at the time of the slice belongs to its upper side, except where the slice is at the lowest time of the
/// element: then to the lower. So every request within the closed time range finds a slice (possibly of measure 0,
/// energy 0), and the slices of elements that share a flat front cover it once. Outside the range the energies are 0.
/// An element's energies depend on no other request. On the host: one `parallel for`.
void slice_energies_host(const SliceEnergyTask& task);

/// The same on an OpenMP device: threads on a CPU device (shape.lanes == 1), one thread per element on a GPU.
/// Synchronous. Without offload in the build it aborts with a message: nobody may call it there.
void slice_energies_device(const SliceEnergyTask& task, int device_number);

}  // namespace tentpole
