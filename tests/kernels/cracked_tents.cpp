#include "tests/kernels/cracked_tents.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

struct InteriorFacet {
  int element, facet;
};

/// Each interior facet of a patch once.
std::vector<InteriorFacet> interior_facets(const TentBatch& batch, const PatchDescriptor& patch) {
  std::vector<InteriorFacet> facets;
  for (int e = patch.first_element; e < patch.first_element + patch.num_elements; ++e)
    for (int facet = 0; facet <= batch.dimension + 1; ++facet)
      if (batch.elements[e].facet_kind[facet] == FacetKind::interior && batch.elements[e].neighbor[facet] > e)
        facets.push_back({e, facet});
  return facets;
}

void append_crack(TentBatch& batch, const InteriorFacet& at, const CrackState& state, bool swap_sides) {
  ElementDescriptor& element = batch.elements[at.element];
  const InteriorFacet sides[2] = {at, {element.neighbor[at.facet], element.neighbor_facet[at.facet]}};
  FractureFacet crack{};
  for (int side = 0; side < 2; ++side) {
    const InteriorFacet& from = sides[swap_sides ? 1 - side : side];
    crack.element[side] = from.element;
    crack.facet[side] = static_cast<std::uint8_t>(from.facet);
    batch.elements[from.element].facet_kind[from.facet] = FacetKind::fracture;
    batch.elements[from.element].facet_data[from.facet] = static_cast<std::int32_t>(batch.fracture_facets.size());
  }
  // The front edge joins the pole and the third vertex of the cell; ids ascend with the corner.
  const int third = 3 - at.facet - element.pole;
  crack.rising_end = batch.dimension == 2 && element.pole > third;
  std::fill(std::begin(crack.damage), std::end(crack.damage), state.damage);
  std::fill(std::begin(crack.gap), std::end(crack.gap), state.gap);
  batch.fracture_facets.push_back(crack);
}

template <class Change>
TentBatch with_crack_facets(TentBatch batch, const Change& change) {
  for (ElementDescriptor& element : batch.elements)
    for (int facet = 0; facet <= batch.dimension + 1; ++facet)
      if (element.facet_kind[facet] == FacetKind::fracture) change(element, facet);
  for (PatchDescriptor& patch : batch.patches) patch.first_fracture = patch.num_fractures = 0;
  batch.fracture_facets.clear();
  batch.fracture_records.clear();
  return batch;
}

}  // namespace

FractureLaw unbreakable_law() {
  return {0.01, 0.02, 1e30, 10, 1, 0.3};
}

void crack_tents(TentBatch& batch, const CrackState& state, std::mt19937& generator) {
  for (PatchDescriptor& patch : batch.patches) {
    std::vector<InteriorFacet> facets = interior_facets(batch, patch);
    std::shuffle(facets.begin(), facets.end(), generator);
    if (facets.size() > 2) facets.erase(facets.begin() + 2, facets.end());
    patch.first_fracture = static_cast<std::int32_t>(batch.fracture_facets.size());
    patch.num_fractures = static_cast<std::int32_t>(facets.size());
    for (const InteriorFacet& facet : facets)
      append_crack(batch, facet, state, std::bernoulli_distribution(0.5)(generator));
  }
  batch.fracture_records.resize(batch.fracture_facets.size());
}

TentBatch cracked_tents(int dimension, int degree, const TentOptions& options, const CrackState& state,
                        std::uint32_t seed, double pressure) {
  std::mt19937 generator(seed);
  TentBatch batch;
  batch.dimension = dimension;
  batch.degree = degree;
  batch.fracture_law = unbreakable_law();
  batch.materials = {random_material(generator)};
  const Material& material = batch.materials[0];
  PolynomialField field = PolynomialField::random(dimension, degree, generator);
  for (int i = 0; i < dimension; ++i) {
    std::array<int, max_dimension + 1> linear{};
    linear[i] = 1;
    field.coefficient(i, linear) -= pressure / (dimension * material.lambda + 2 * material.mu);
  }
  for (int patch = 0; patch < options.num_patches; ++patch) {
    const bool at_boundary = dimension == 2 && std::bernoulli_distribution(options.boundary_fraction)(generator);
    TentGeometry tent = random_star(dimension, at_boundary, options.shape, generator);
    const std::vector<double> wave_speed(tent.cells.size(), material.dilatational_speed());
    raise_tent(tent, wave_speed, options.front_steepness, options.height_fraction, generator);
    append_tent(batch, tent, std::vector<int>(tent.cells.size(), 0), {field}, options.data, generator);
  }
  crack_tents(batch, state, generator);
  return batch;
}

FractureLaw breaking_law(const TentBatch& batch, double relaxation_time) {
  double largest = 0;
  for (const FractureRecord& record : solved(batch).fracture_records)
    largest = std::max(largest, record.largest_effective_traction);
  return {0.2 * largest, 0.9 * largest, relaxation_time, 10, 0.8, 0.3};
}

TentBatch without_cracks(TentBatch batch) {
  return with_crack_facets(std::move(batch), [](ElementDescriptor& element, int facet) {
    element.facet_kind[facet] = FacetKind::interior;
    element.facet_data[facet] = none;
  });
}

TentBatch cut_along_cracks(TentBatch batch) {
  return with_crack_facets(std::move(batch), [](ElementDescriptor& element, int facet) {
    element.facet_kind[facet] = FacetKind::boundary;
    element.facet_data[facet] = element.neighbor[facet] = none;
    element.normal_kind[facet] = element.tangential_kind[facet] = BoundaryKind::traction;
  });
}

CrackedBalance balance_with_cracks(const TentBatch& batch, const PatchDescriptor& patch) {
  CrackedBalance balance;
  for (int f = patch.first_fracture; f < patch.first_fracture + patch.num_fractures; ++f) {
    balance.fracture += batch.fracture_records[f].fracture_work;
    balance.friction += batch.fracture_records[f].friction_work;
  }
  balance.closure = balance.fracture + balance.friction;
  for (int e = patch.first_element; e < patch.first_element + patch.num_elements; ++e) {
    const ElementRecord& record = batch.records[e];
    balance.closure += record.outflow_energy - record.inflow_energy + record.dissipation - record.external_work;
    balance.dissipation += record.dissipation;
    balance.largest =
        std::max({balance.largest, record.inflow_energy, record.outflow_energy, std::abs(record.external_work)});
  }
  return balance;
}

double difference_of_solutions(const TentBatch& left, const TentBatch& right) {
  double difference = 0;
  const int n = left.num_unknowns();
  for (const PatchDescriptor& patch : left.patches) {
    double scale = 0, largest = 0;
    for (int e = patch.first_element; e < patch.first_element + patch.num_elements; ++e)
      for (int i = 0; i < n; ++i) {
        const long entry = static_cast<long>(left.elements[e].result_slot) * n + i;
        const double step = std::abs(left.coefficients[entry] - right.coefficients[entry]);
        if (std::isnan(step)) return std::numeric_limits<double>::quiet_NaN();
        scale = std::max(scale, std::abs(left.coefficients[entry]));
        largest = std::max(largest, step);
      }
    difference = std::max(difference, largest / scale);
  }
  return difference;
}

}  // namespace tentpole
