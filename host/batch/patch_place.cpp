#include "host/batch/patch_place.hpp"

#include <cstdio>

namespace tentpole {

std::string patch_place(const HostBatch& batch, const PatchDescriptor& patch, const Simulation& simulation) {
  const ElementDescriptor& element = batch.elements[patch.first_element];
  const int dimension = simulation.dimension();
  int lowest = 0;
  for (int corner = 1; corner <= dimension + 1; ++corner)
    if (element.corner[corner][dimension] < element.corner[lowest][dimension]) lowest = corner;
  if (element.pole != none) lowest = element.pole;
  std::string place;
  char number[32];
  for (int axis = 0; axis < dimension; ++axis) {
    std::snprintf(number, sizeof number, "%s%.6g", axis ? ", " : "",
                  element.corner[lowest][axis] * simulation.scaling.length);
    place += number;
  }
  std::snprintf(number, sizeof number, "%.6g", element.corner[lowest][dimension] * simulation.scaling.time());
  return "cell " + std::to_string(batch.cells[patch.first_element]) + ", " + (element.pole == none ? "patch" : "tent") +
         " at (" + place + ") m, t = " + number + " s";
}

}  // namespace tentpole
