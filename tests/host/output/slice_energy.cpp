#include "tests/host/output/slice_energy.hpp"

#include "host/output/slice.hpp"

namespace tentpole {
namespace {

/// Maps a quadrature point of the unit simplex to the simplex of the slice with these corners, at `time`.
std::array<double, 4> map_point(const Slice& slice, const std::array<int, 4>& corners, const double* xi, double time) {
  const int dimension = dimension_of(slice.shape);
  std::array<double, 4> point{};
  for (int i = 0; i < dimension; ++i) {
    const double origin = slice.point[corners[0]][i];
    point[i] = origin;
    for (int l = 0; l < dimension; ++l) point[i] += xi[l] * (slice.point[corners[l + 1]][i] - origin);
  }
  point[dimension] = time;
  return point;
}

}  // namespace

SliceEnergy slice_energy(const OrthonormalBasis& basis, const Quadrature& rule, const SpacetimeElement& element,
                         double time) {
  SliceEnergy energy;
  const std::optional<Slice> slice = slice_element(element, time);
  if (!slice) return energy;
  const ElementFields fields(basis, element);
  const int dimension = element.dimension;
  for (const auto& corners : simplices_of(slice->shape)) {
    const double determinant = simplex_determinant(*slice, corners);
    for (int q = 0; q < rule.num_points(); ++q) {
      const auto point = map_point(*slice, corners, rule.points.data() + q * dimension, time);
      const PointFields value = fields.at(std::span(point).first(dimension + 1));
      const double weight = rule.weights[q] * determinant;
      for (const double v : value.velocity) energy.kinetic += 0.5 * element.material.density * weight * v * v;
      energy.strain += weight * value.strain_energy_density;
    }
  }
  return energy;
}

}  // namespace tentpole
