#include "host/problem/initial_element.hpp"

#include <algorithm>

namespace tentpole {

ElementDescriptor initial_element(const Simulation& simulation, int cell) {
  const SpaceMesh& mesh = simulation.mesh;
  ElementDescriptor element{};
  for (int corner = 0; corner <= mesh.dimension; ++corner) {
    const Point position = mesh.corner_position(cell, corner);
    std::copy_n(position.begin(), mesh.dimension, element.corner[corner]);
  }
  element.material = mesh.cell_region[cell];
  return element;
}

}  // namespace tentpole
