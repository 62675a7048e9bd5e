#include "bench/sample_patches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "kernels/element/larger_or_nan.hpp"

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

TentBatch repeat_patches(const TentBatch& batch, int num_patches) {
  const int n = batch.num_unknowns(), jacobian_size = (batch.dimension + 1) * (batch.dimension + 1);
  TentBatch repeated = batch;
  repeated.patches.clear();
  repeated.elements.clear();
  repeated.exact.clear();
  for (int copy = 0; copy < num_patches; ++copy) {
    PatchDescriptor patch = batch.patches[copy % batch.patches.size()];
    const int original = patch.first_element, shift = static_cast<int>(repeated.elements.size()) - original;
    patch.first_element += shift;
    repeated.patches.push_back(patch);
    for (int e = original; e < original + patch.num_elements; ++e) {
      ElementDescriptor element = batch.elements[e];
      for (int facet = 0; facet <= batch.dimension + 1; ++facet)
        if (is_shared(element.facet_kind[facet])) element.neighbor[facet] += shift;
      element.result_slot = repeated.num_slots();
      repeated.elements.push_back(element);
      const double unwritten = std::numeric_limits<double>::quiet_NaN();
      repeated.coefficients.insert(repeated.coefficients.end(), n, unwritten);
      repeated.inverse_jacobians.insert(repeated.inverse_jacobians.end(), jacobian_size, unwritten);
      const double* exact = batch.exact.data() + static_cast<std::size_t>(e) * n;
      repeated.exact.insert(repeated.exact.end(), exact, exact + n);
    }
  }
  repeated.records.assign(repeated.elements.size(), ElementRecord{});
  return repeated;
}

double polynomial_error(const TentBatch& batch, int num_elements) {
  const long n = batch.num_unknowns();
  double error = 0;
  for (long element = 0; element < num_elements; ++element) {
    const double* computed = batch.coefficients.data() + batch.elements[element].result_slot * n;
    const double* exact = batch.exact.data() + element * n;
    double difference = 0, scale = 0;
    for (long a = 0; a < n; ++a) {
      difference = larger_or_nan(difference, std::abs(computed[a] - exact[a]));
      scale = std::max(scale, std::abs(exact[a]));
    }
    error = larger_or_nan(error, difference / scale);
  }
  return error;
}

}  // namespace tentpole
