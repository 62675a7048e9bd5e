#pragma once

#include <span>

#include "kernels/element/patch_batch.hpp"
#include "kernels/element/reference_tables.hpp"
#include "kernels/launch/cycle_counter.hpp"
#include "kernels/launch/launch.hpp"

namespace tentpole {

/// Everything one launch needs; all pointers in the memory of the device that runs it.
struct PatchSolverTask {
  PatchBatch batch;
  ReferenceTablesView tables;
  double* scratch;      ///< [workers][scratch_stride]
  long scratch_stride;  ///< >= the largest patch_scratch_size of the batch
  StageCycles* cycles;  ///< [workers], added to
  LaunchShape shape;
};

/// Doubles of scratch one worker needs for this patch, or for any of these.
long patch_scratch_size(const ReferenceTablesView& tables, const PatchDescriptor& patch, int lanes);
long patch_scratch_size(const ReferenceTablesView& tables, std::span<const PatchDescriptor> patches, int lanes);

/// Solves all patches of the batch by trace condensation (kernels/patch/solve_patch.hpp). The result of a patch does
/// not depend on the number of workers nor on the other patches. Status and residual of each element are in its record.
/// Cost per element: see flops_per_element. On the host: one `parallel for`.
void solve_patches_host(const PatchSolverTask& task);

/// The same on an OpenMP device: threads on a CPU device (shape.lanes == 1), teams of lanes otherwise. Synchronous.
/// Without offload in the build it aborts with a message: nobody may call it there.
void solve_patches_device(const PatchSolverTask& task, int device_number);

/// Fills the records of all patches (and the store's inverse Jacobians) from coefficients that are already in the
/// element store, as solve_patches would. Host pointers, serial; a status other than ok where the residual is above
/// 1e-8.
void evaluate_patches_host(const PatchBatch& batch, const ReferenceTablesView& tables);

/// Modelled floating-point operations of one element with `num_ports` interior vertical facets in a patch that took
/// `iterations` coupling products: assembly + elimination + coupling + recovery (multiply and add count as two).
double flops_per_element(const ReferenceTablesView& tables, int num_ports, int iterations);

}  // namespace tentpole
