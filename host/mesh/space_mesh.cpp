#include "host/mesh/space_mesh.hpp"

#include <cmath>

#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {

double SpaceMesh::cell_measure(int cell) const {
  std::array<Point, max_corners> corners{};
  for (int i = 0; i <= dimension; ++i) corners[i] = corner_position(cell, i);
  return std::abs(signed_simplex_measure(dimension, corners));
}

double SpaceMesh::mean_cell_size() const {
  double measure = 0;
  for (int cell = 0; cell < num_cells(); ++cell) measure += cell_measure(cell);
  return std::pow(measure / num_cells(), 1.0 / dimension);
}

void SpaceMesh::scale_lengths(double factor) {
  for (Point& vertex : vertices)
    for (double& coordinate : vertex) coordinate *= factor;
  for (Point& shift : shifts)
    for (double& coordinate : shift) coordinate *= factor;
}

}  // namespace tentpole
