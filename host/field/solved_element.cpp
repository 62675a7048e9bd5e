#include "host/field/solved_element.hpp"

namespace tentpole {

SpacetimeElement spacetime_element(const Simulation& simulation, const HostBatch& batch, std::int32_t index) {
  const ElementDescriptor& from = batch.elements[index];
  SpacetimeElement element;
  element.dimension = simulation.dimension();
  for (int corner = 0; corner <= element.dimension + 1; ++corner) {
    for (int axis = 0; axis < element.dimension; ++axis)
      element.corner[corner][axis] = from.corner[corner][axis] * simulation.scaling.length;
    element.corner[corner][element.dimension] = simulation.time_in_seconds(from.corner[corner][element.dimension]);
  }
  element.region = from.material;
  element.id = batch.cells[index];
  if (!batch.damage.empty()) element.damage = batch.damage[index];
  element.material = simulation.materials[from.material];
  return element;
}

std::vector<double> solved_coefficients(const Simulation& simulation, const HostBatch& batch, std::size_t index) {
  const std::size_t n = batch.wanted_coefficients.size() / batch.wanted.size();
  std::vector<double> coefficients(batch.wanted_coefficients.begin() + index * n,
                                   batch.wanted_coefficients.begin() + (index + 1) * n);
  for (double& coefficient : coefficients) coefficient *= simulation.scaling.length;
  return coefficients;
}

}  // namespace tentpole
