#include "host/batch/batch_runner.hpp"

#include <algorithm>
#include <chrono>

#include <omp.h>

#include "host/batch/dense_fallback.hpp"
#include "host/batch/energy_balance.hpp"

namespace tentpole {
BatchRunner::BatchRunner(const Simulation& simulation, const Device& device, int threads, StageTimer& timer,
                         TrafficCounters& traffic)
    : simulation_(simulation),
      device_(device),
      shape_(device_shape(device, threads)),
      num_host_threads_(threads > 0 ? threads : omp_get_max_threads()),
      timer_(timer),
      traffic_(traffic),
      host_tables_(simulation.dimension(), simulation.degree()),
      host_slice_tables_(simulation.dimension(), simulation.degree()),
      host_transplant_tables_(simulation.dimension(), simulation.degree()),
      fracture_law_(scaled_fracture_law(simulation)),
      tables_(device, traffic, std::ssize(host_tables_.block())),
      slice_tables_(device, traffic, std::ssize(host_slice_tables_.block())),
      transplant_tables_(device, traffic, std::ssize(host_transplant_tables_.block())),
      materials_(device, traffic, std::ssize(simulation.scaled_materials)),
      coefficients_(device, traffic),
      inverse_jacobians_(device, traffic),
      patches_(device, traffic),
      elements_(device, traffic),
      prescribed_(device, traffic),
      records_(device, traffic),
      fractures_(device, traffic),
      fracture_records_(device, traffic),
      transplants_(device, traffic),
      slice_requests_(device, traffic),
      slice_energies_(device, traffic),
      scratch_(device, traffic, shape_),
      slots_(device, traffic) {
  tables_.upload(host_tables_.block());
  slice_tables_.upload(host_slice_tables_.block());
  transplant_tables_.upload(host_transplant_tables_.block());
  materials_.upload(simulation.scaled_materials);
}

void BatchRunner::run(HostBatch& batch) {
  {
    ScopedStage stage(timer_, Stage::transfer);
    prepare_memory(batch);
    upload(batch);
  }
  launch();
  {
    ScopedStage stage(timer_, Stage::transfer);
    download(batch);
  }
  repair_failed_patches(batch);
  compute_energies(batch);
  compute_slice_energies(batch);
  gather_wanted(batch);
}

void BatchRunner::compute_energies(HostBatch& batch) {
  batch.energies.assign(batch.patches.size(), {});
  for (std::size_t patch = 0; patch < batch.patches.size(); ++patch)
    if (static_cast<Status>(batch.records[batch.patches[patch].first_element].status) == Status::ok)
      batch.energies[patch] = patch_energies(batch, batch.patches[patch], simulation_);
}

void BatchRunner::compute_slice_energies(HostBatch& batch) {
  if (batch.slice_requests.empty()) return;
  SliceEnergyTask slices{};
  {
    ScopedStage stage(timer_, Stage::transfer);
    slice_requests_.resize_discarding(std::ssize(batch.slice_requests));
    slice_energies_.resize_discarding(2 * std::ssize(batch.slice_requests));
    slice_requests_.upload(batch.slice_requests);
  }
  slices.batch = device_batch(batch);
  slices.tables = host_tables_.view(tables_.pointer());
  slices.slice_tables = host_slice_tables_.view(slice_tables_.pointer());
  slices.num_requests = static_cast<int>(batch.slice_requests.size());
  slices.requests = slice_requests_.pointer();
  slices.energies = slice_energies_.pointer();
  slices.shape = shape_;
  {
    ScopedStage stage(timer_, Stage::post_solution);
    if (device_.is_host) {
      slice_energies_host(slices);
    } else {
      traffic_.count_launch(sizeof slices);
      slice_energies_device(slices, device_.number);
    }
  }
  ScopedStage stage(timer_, Stage::transfer);
  batch.slice_energies.resize(2 * batch.slice_requests.size());
  slice_energies_.download(batch.slice_energies);
}

void BatchRunner::gather_wanted(HostBatch& batch) {
  ScopedStage stage(timer_, Stage::transfer);
  const int n = host_tables_.view().num_unknowns;
  std::vector<std::int32_t> slots;
  for (const std::int32_t element : batch.wanted) slots.push_back(batch.elements[element].result_slot);
  batch.wanted_coefficients.resize(slots.size() * n);
  if (!slots.empty()) slots_.gather(coefficients_, n, slots, batch.wanted_coefficients);
}

void BatchRunner::prepare_memory(const HostBatch& batch) {
  hold_slots(batch.num_slots);
  patches_.resize_discarding(std::ssize(batch.patches));
  elements_.resize_discarding(std::ssize(batch.elements));
  prescribed_.resize_discarding(std::ssize(batch.prescribed));
  records_.resize_discarding(std::ssize(batch.elements));
  fractures_.resize_discarding(std::ssize(batch.fractures));
  fracture_records_.resize_discarding(std::ssize(batch.fractures));
  task_.batch = device_batch(batch);
  task_.tables = host_tables_.view(tables_.pointer());
  scratch_.prepare(batch.patches, task_);
}

void BatchRunner::hold_slots(std::int64_t num_slots) {
  const std::int64_t n = host_tables_.view().num_unknowns, d = simulation_.dimension() + 1;
  if (coefficients_.size() >= num_slots * n) return;
  coefficients_.grow_keeping(num_slots * n);
  inverse_jacobians_.grow_keeping(num_slots * d * d);
}

void BatchRunner::upload(const HostBatch& batch) {
  patches_.upload(batch.patches);
  elements_.upload(batch.elements);
  if (!batch.prescribed.empty()) prescribed_.upload(batch.prescribed);
  if (!batch.fractures.empty()) fractures_.upload(batch.fractures);
}

PatchBatch BatchRunner::device_batch(const HostBatch& batch) {
  PatchBatch on_device{};
  on_device.num_patches = static_cast<int>(batch.patches.size());
  on_device.num_elements = static_cast<int>(batch.elements.size());
  on_device.patches = patches_.pointer();
  on_device.elements = elements_.pointer();
  on_device.prescribed = prescribed_.pointer();
  on_device.materials = materials_.pointer();
  on_device.coefficients = coefficients_.pointer();
  on_device.inverse_jacobians = inverse_jacobians_.pointer();
  on_device.records = records_.pointer();
  on_device.fracture_law = fracture_law_;
  on_device.fracture_facets = fractures_.pointer();
  on_device.fracture_records = fracture_records_.pointer();
  return on_device;
}

void BatchRunner::launch() {
  const auto start = std::chrono::steady_clock::now();
  if (device_.is_host) {
    solve_patches_host(task_);
  } else {
    traffic_.count_launch(sizeof task_);
    solve_patches_device(task_, device_.number);
  }
  const auto elapsed = std::chrono::steady_clock::now() - start;
  const StageCycles sum = scratch_.total_cycles();
  const double all = std::max<double>(1, static_cast<double>(sum.assembly + sum.solution + sum.post_solution));
  const auto share = [&](long long part) {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(elapsed * (static_cast<double>(part) / all));
  };
  timer_.add(Stage::assembly, share(sum.assembly));
  timer_.add(Stage::solution, share(sum.solution));
  timer_.add(Stage::post_solution, share(sum.post_solution));
}

void BatchRunner::download(HostBatch& batch) {
  batch.records.resize(batch.elements.size());
  records_.download(batch.records);
  batch.fracture_records.resize(batch.fractures.size());
  if (!batch.fractures.empty()) fracture_records_.download(batch.fracture_records);
  const ReferenceTablesView tables = host_tables_.view();
  for (std::size_t e = 0; e < batch.elements.size(); ++e) {
    int ports = 0;
    for (int facet = 0; facet <= tables.dimension + 1; ++facet) ports += is_shared(batch.elements[e].facet_kind[facet]);
    batch.modelled_flops += flops_per_element(tables, ports, batch.records[e].num_iterations);
  }
}

void BatchRunner::repair_failed_patches(HostBatch& batch) {
  for (const PatchDescriptor& patch : batch.patches) {
    const Status status = static_cast<Status>(batch.records[patch.first_element].status);
    if (status == Status::ok || patch.num_fractures > 0) continue;
    std::vector<std::int32_t> slots;
    for (int e = 0; e < patch.num_elements; ++e)
      for (int facet = 0; facet <= simulation_.dimension() + 1; ++facet)
        if (has_source(batch.elements[patch.first_element + e], facet))
          slots.push_back(batch.elements[patch.first_element + e].source_slot[facet]);
    DenseFallback fallback(batch, patch, simulation_, host_tables_);
    std::vector<double> coefficients, inverse_jacobians;
    read_slots(slots, coefficients, inverse_jacobians);
    fallback.solve(slots, coefficients, inverse_jacobians);
    write_slots(fallback.result_slots(), fallback.coefficients(), fallback.inverse_jacobians());
    ++num_fallbacks_;
  }
}

void BatchRunner::transplant(std::span<const TransplantRequest> requests, std::int32_t num_slots) {
  if (requests.empty()) return;
  TransplantTask task{};
  {
    ScopedStage stage(timer_, Stage::transfer);
    hold_slots(num_slots);
    transplants_.resize_discarding(std::ssize(requests));
    transplants_.upload(requests);
  }
  task.tables = host_transplant_tables_.view(transplant_tables_.pointer());
  task.num_requests = static_cast<int>(requests.size());
  task.requests = transplants_.pointer();
  task.coefficients = coefficients_.pointer();
  task.inverse_jacobians = inverse_jacobians_.pointer();
  task.shape = shape_;
  const ScopedStage stage(timer_, Stage::solution);
  if (device_.is_host) {
    transplant_host(task);
  } else {
    traffic_.count_launch(sizeof task);
    transplant_device(task, device_.number);
  }
}

void BatchRunner::read_slots(std::span<const std::int32_t> slots, std::vector<double>& coefficients,
                             std::vector<double>& inverse_jacobians) {
  const std::int64_t n = host_tables_.view().num_unknowns, d = simulation_.dimension() + 1;
  coefficients.resize(slots.size() * n);
  inverse_jacobians.resize(slots.size() * d * d);
  if (slots.empty()) return;
  slots_.gather(coefficients_, n, slots, coefficients);
  slots_.gather(inverse_jacobians_, d * d, slots, inverse_jacobians);
}

void BatchRunner::write_slots(std::span<const std::int32_t> slots, std::span<const double> coefficients,
                              std::span<const double> inverse_jacobians) {
  if (slots.empty()) return;
  const std::int64_t n = host_tables_.view().num_unknowns, d = simulation_.dimension() + 1;
  hold_slots(*std::max_element(slots.begin(), slots.end()) + std::int64_t{1});
  slots_.scatter(coefficients_, n, slots, coefficients);
  slots_.scatter(inverse_jacobians_, d * d, slots, inverse_jacobians);
}

}  // namespace tentpole
