#include "host/run/tent_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "host/front/front.hpp"

namespace tentpole {
namespace {

/// Spacetime measure of a tent: its elements are simplices over the cells of the star, each |cell| height / (D + 1).
double tent_measure(const std::vector<double>& cell_measure, std::span<const CellCorner> star, double height,
                    int dimension) {
  double base = 0;
  for (const CellCorner& corner : star) base += cell_measure[corner.cell];
  return base * height / (dimension + 1);
}

}  // namespace

TentEstimate estimate_tents(const Simulation& simulation, std::int64_t max_patches) {
  const SpaceMesh& mesh = simulation.mesh;
  const double end_time = simulation.scaled_end_time();
  std::vector<double> cell_measure(mesh.num_cells());
  double whole = 0, pitched = 0;
  for (int cell = 0; cell < mesh.num_cells(); ++cell)
    whole += end_time * (cell_measure[cell] = mesh.cell_measure(cell));

  TentEstimate estimate;
  Front front(mesh, simulation.cell_wave_speed, simulation.settings.front.causality);
  std::vector<int> minima;
  do {
    minima = front.next_minima(1024, end_time);
    for (const int vertex : minima) {
      const auto star = front.star(vertex);
      const double top = front.pole_top_time(vertex, end_time);
      pitched += tent_measure(cell_measure, star, top - front.time(vertex), mesh.dimension);
      front.raise(vertex, top);
      estimate.patches += 1;
      estimate.elements += static_cast<double>(star.size());
      estimate.largest_patch = std::max(estimate.largest_patch, static_cast<int>(star.size()));
    }
  } while (!minima.empty() && estimate.patches < static_cast<double>(max_patches));
  estimate.is_exact = front.minimum_time() >= end_time;
  if (estimate.is_exact) return estimate;
  estimate.patches = std::round(estimate.patches * (whole / pitched));
  estimate.elements = std::round(estimate.elements * (whole / pitched));
  return estimate;
}

}  // namespace tentpole
