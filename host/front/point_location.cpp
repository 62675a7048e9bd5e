#include "host/front/point_location.hpp"

#include <cmath>

namespace tentpole {

namespace {

constexpr double tolerance = 1e-10;

/// The facet behind which the point lies farthest, in barycentric coordinates.
struct Facing {
  int facet;
  double coordinate;  ///< negative outside the cell
};

Facing worst_facet(const FrontSimplex& cell, const Point& point) {
  const double measure = signed_measure(cell);
  Facing worst{0, 2};
  for (int facet = 0; facet <= cell.dimension; ++facet) {
    FrontSimplex part = cell;
    part.position[facet] = point;
    const double coordinate = signed_measure(part) / measure;
    if (coordinate < worst.coordinate) worst = {facet, coordinate};
  }
  return worst;
}

std::int32_t first_alive_cell(const FrontMesh& mesh) {
  int cell = 0;
  while (!mesh.is_alive_cell(cell)) ++cell;
  return cell;
}

std::int32_t search_all(const FrontMesh& mesh, const Point& point) {
  for (int cell = 0; cell < mesh.num_cell_slots(); ++cell)
    if (mesh.is_alive_cell(cell) && worst_facet(mesh.simplex(cell), point).coordinate >= -tolerance) return cell;
  return none;
}

}  // namespace

std::int32_t locate(const FrontMesh& mesh, const Point& point, std::int32_t start) {
  const bool is_usable = start >= 0 && start < mesh.num_cell_slots() && mesh.is_alive_cell(start);
  std::int32_t cell = is_usable ? start : first_alive_cell(mesh);
  const int max_steps = mesh.dimension() == 1 ? mesh.num_cells() : 100 + 4 * int(std::sqrt(double(mesh.num_cells())));
  for (int step = 0; step < max_steps && cell != none; ++step) {
    const Facing worst = worst_facet(mesh.simplex(cell), point);
    if (worst.coordinate >= -tolerance) return cell;
    cell = mesh.cell(cell).neighbor[worst.facet];
  }
  return search_all(mesh, point);
}

}  // namespace tentpole
