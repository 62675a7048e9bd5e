#include "kernels/launch/slice_energies.hpp"

#include "kernels/element/with_dimension.hpp"
#include "kernels/formulation/one_field/slice_integral.hpp"

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

constexpr int chunk = 16;  // requests that a thread takes at a time

/// All requests of an element, by whoever meets the first of them.
template <int D>
struct ElementSlices {
  SliceEnergyTask task;
  void operator()(int request) const {
    if (is_first_of_element(task, request)) run_element<D>(task, request);
  }
};

}  // namespace

void slice_energies_host(const SliceEnergyTask& task) {
  with_dimension(task.tables.dimension, [&](auto dimension) {
    loop_on_host(task.shape, task.num_requests, chunk, ElementSlices<dimension()>{task});
  });
}

void slice_energies_device([[maybe_unused]] const SliceEnergyTask& task, [[maybe_unused]] int device_number) {
#ifdef TENTPOLE_OFFLOAD
  with_dimension(task.tables.dimension, [&](auto dimension) {
    loop_on_device(task.shape, task.num_requests, chunk, ElementSlices<dimension()>{task}, device_number);
  });
#else
  refuse_launch("slice_energies_device");
#endif
}

}  // namespace tentpole
