#include "kernels/slice_energies.hpp"

#include <cstdio>
#include <cstdlib>

#include "kernels/slice_integral.hpp"
#include "kernels/with_dimension.hpp"

namespace tentpole {
namespace {

/// All requests of the element of request `first`, which is the first of them.
template <int D>
inline void run_element(const SliceEnergyTask& task, int first) {
  const ElementDescriptor& element = task.batch.elements[task.requests[first].element];
  const Material& material = task.batch.materials[element.material];
  const long slot = element.result_slot;
  FieldModes<D> fields;
  field_modes<D>(task.tables, task.batch.coefficients + slot * task.tables.num_unknowns,
                 task.batch.inverse_jacobians + slot * (D + 1) * (D + 1), fields);
  for (int request = first; request < task.num_requests; ++request) {
    if (task.requests[request].element != task.requests[first].element) break;
    const SliceEnergies energies =
        slice_energies<D>(task.slice_tables, element, material, fields, task.requests[request].time);
    task.energies[2 * request] = energies.kinetic;
    task.energies[2 * request + 1] = energies.strain;
  }
}

inline bool is_first_of_element(const SliceEnergyTask& task, int request) {
  return request == 0 || task.requests[request - 1].element != task.requests[request].element;
}

template <int D>
void run_on_host(const SliceEnergyTask& task) {
#pragma omp parallel for schedule(monotonic : dynamic, 16) num_threads(task.shape.workers)
  for (int request = 0; request < task.num_requests; ++request)
    if (is_first_of_element(task, request)) run_element<D>(task, request);
}

#ifdef TENTPOLE_OFFLOAD
template <int D>
void run_on_cpu_device(const SliceEnergyTask task, int device_number) {
  const int num_requests = task.num_requests, workers = task.shape.workers;
#pragma omp target teams num_teams(1) device(device_number) firstprivate(task)
#pragma omp parallel for num_threads(workers) schedule(monotonic : dynamic, 16)
  for (int request = 0; request < num_requests; ++request)
    if (is_first_of_element(task, request)) run_element<D>(task, request);
}

template <int D>
void run_on_gpu(const SliceEnergyTask task, int device_number) {
  const int num_requests = task.num_requests;
#pragma omp target teams distribute parallel for device(device_number) firstprivate(task)
  for (int request = 0; request < num_requests; ++request)
    if (is_first_of_element(task, request)) run_element<D>(task, request);
}
#endif

}  // namespace

void slice_energies_host(const SliceEnergyTask& task) {
  with_dimension(task.tables.dimension, [&](auto dimension) { run_on_host<dimension()>(task); });
}

void slice_energies_device([[maybe_unused]] const SliceEnergyTask& task, [[maybe_unused]] int device_number) {
#ifdef TENTPOLE_OFFLOAD
  with_dimension(task.tables.dimension, [&](auto dimension) {
    if (task.shape.lanes == 1)
      run_on_cpu_device<dimension()>(task, device_number);
    else
      run_on_gpu<dimension()>(task, device_number);
  });
#else
  std::fputs("slice_energies_device: this build has no device code (preset host)\n", stderr);
  std::abort();
#endif
}

}  // namespace tentpole
