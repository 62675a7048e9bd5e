#include "tests/kernels/device_tents.hpp"

#include <algorithm>

namespace tentpole {

DeviceTents::DeviceTents(const TentBatch& batch, const Device& device)
    : device_(device),
      tables_(batch.dimension, batch.degree),
      host_patches_(batch.patches),
      table_block_(uploaded(tables_.block())),
      patches_(uploaded(batch.patches)),
      elements_(uploaded(batch.elements)),
      prescribed_(uploaded(batch.prescribed)),
      materials_(uploaded(batch.materials)),
      coefficients_(uploaded(batch.coefficients)),
      inverse_jacobians_(uploaded(batch.inverse_jacobians)),
      records_(uploaded(batch.records)),
      fracture_law_(batch.fracture_law),
      fracture_facets_(uploaded(batch.fracture_facets)),
      fracture_records_(uploaded(batch.fracture_records)) {}

PatchBatch DeviceTents::view() {
  PatchBatch view{};
  view.num_patches = static_cast<int>(patches_.size());
  view.num_elements = static_cast<int>(elements_.size());
  view.patches = patches_.pointer();
  view.elements = elements_.pointer();
  view.prescribed = prescribed_.pointer();
  view.materials = materials_.pointer();
  view.coefficients = coefficients_.pointer();
  view.inverse_jacobians = inverse_jacobians_.pointer();
  view.records = records_.pointer();
  view.fracture_law = fracture_law_;
  view.fracture_facets = fracture_facets_.pointer();
  view.fracture_records = fracture_records_.pointer();
  return view;
}

void DeviceTents::solve(LaunchShape shape) {
  PatchSolverTask task{};
  task.batch = view();
  task.tables = tables();
  task.scratch_stride = patch_scratch_size(task.tables, host_patches_, shape.lanes);
  DeviceBuffer<double> scratch(device_, traffic_, task.scratch_stride * shape.workers);
  DeviceBuffer<StageCycles> cycles = uploaded(std::vector<StageCycles>(shape.workers));
  task.scratch = scratch.pointer();
  task.cycles = cycles.pointer();
  task.shape = shape;
  if (device_.is_host) {
    solve_patches_host(task);
  } else {
    solve_patches_device(task, device_.number);
  }
}

void DeviceTents::download(TentBatch& batch) {
  coefficients_.download(batch.coefficients);
  inverse_jacobians_.download(batch.inverse_jacobians);
  if (!batch.records.empty()) records_.download(batch.records);
  if (!batch.fracture_records.empty()) fracture_records_.download(batch.fracture_records);
}

TentBatch solved(TentBatch batch, const Device& device, LaunchShape shape) {
  DeviceTents tents(batch, device);
  tents.solve(shape);
  tents.download(batch);
  return batch;
}

TentBatch solved(TentBatch batch) {
  return solved(std::move(batch), host_device(), {1, 1});
}

}  // namespace tentpole
