#include "bench/sample_patches.hpp"

#include <stdexcept>
#include <string>

namespace tentpole {
namespace {

TentGeometry star_of(int dimension, int num_elements, std::mt19937& generator) {
  StarShape shape;
  shape.min_angle_degrees = 30;
  shape.max_angle_degrees = 100;
  for (int attempt = 0; attempt < 100; ++attempt) {
    TentGeometry star = random_star(dimension, false, shape, generator);
    if (static_cast<int>(star.cells.size()) < num_elements) continue;
    star.cells.resize(num_elements);
    return star;
  }
  throw std::invalid_argument("no star of dimension " + std::to_string(dimension) + " has " +
                              std::to_string(num_elements) + " cells");
}

}  // namespace

TentBatch sample_patches(int space_dimension, int degree, int num_elements, int num_patches) {
  constexpr double front_steepness = 0.6, height_fraction = 0.9;
  std::mt19937 generator(20140501);
  TentBatch batch;
  batch.dimension = space_dimension;
  batch.degree = degree;
  batch.materials.push_back(random_material(generator));
  const std::vector<PolynomialField> fields{PolynomialField::random(space_dimension, degree, generator)};
  const std::vector<int> material(num_elements, 0);
  const std::vector<double> wave_speed(num_elements, batch.materials[0].dilatational_speed());
  TentData data;
  data.source_fraction = 0;
  data.normal_kind = data.tangential_kind = BoundaryKind::absorbing;
  for (int patch = 0; patch < num_patches; ++patch) {
    TentGeometry tent = star_of(space_dimension, num_elements, generator);
    raise_tent(tent, wave_speed, front_steepness, height_fraction, generator);
    append_tent(batch, tent, material, fields, data, generator);
  }
  return batch;
}

}  // namespace tentpole
