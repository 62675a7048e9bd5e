#include "bench/assembly/reference_cell.hpp"

#include <cmath>

#include <cblas.h>

#include "kernels/reference/point_state.reference.hpp"
#include "kernels/reference/rigid_modes.reference.hpp"

namespace tentpole {
namespace {

using namespace reference;

/// K += sum of weight test trial^T, collected and multiplied a few hundred terms at a time.
class TermSum {
 public:
  explicit TermSum(int num_unknowns) : n_(num_unknowns), matrix_(static_cast<std::size_t>(n_) * n_, 0.0) {}

  void add(double weight, const Row& test, const Row& trial) {
    for (int m = 0; m < n_; ++m) tests_.push_back(weight * test[m]);
    trials_.insert(trials_.end(), trial.begin(), trial.end());
    if (++num_terms_ == 512) multiply();
  }

  std::vector<double> take() {
    multiply();
    return std::move(matrix_);
  }

 private:
  void multiply() {
    cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, n_, n_, num_terms_, 1.0, tests_.data(), n_, trials_.data(), n_,
                1.0, matrix_.data(), n_);
    tests_.clear();
    trials_.clear();
    num_terms_ = 0;
  }

  int n_;
  std::vector<double> matrix_, tests_, trials_;
  int num_terms_ = 0;
};

/// factor a + other_factor b
Row sum(double factor, const Row& a, double other_factor, const Row& b) {
  Row result(a.size());
  for (std::size_t n = 0; n < a.size(); ++n) result[n] = factor * a[n] + other_factor * b[n];
  return result;
}

struct Cell {
  const Discretization& disc;
  const ElementDescriptor& element;
  const Material& material;
  Geometry geometry;

  PointState state_on(int facet, int q) const {
    const Row xi = element_point(facet_barycentric(disc, q), facet_corners(disc.dimension, facet));
    return point_state(disc, geometry.inverse, material, xi);
  }
};

void add_volume(const Cell& cell, TermSum& terms) {
  const Discretization& disc = cell.disc;
  const int d = disc.dimension + 1;
  for (int q = 0; q < disc.volume_rule.num_points(); ++q) {
    const Row xi(&disc.volume_rule.points[q * d], &disc.volume_rule.points[q * d] + d);
    const PointState test = point_state(disc, cell.geometry.inverse, cell.material, xi);
    const Rows momentum = momentum_operator(disc, cell.geometry.inverse, cell.material, xi);
    for (int i = 0; i < disc.dimension; ++i)
      terms.add(disc.volume_rule.weights[q] * cell.geometry.determinant, test.velocity[i], momentum[i]);
  }
}

/// - w^T A_N w with A_N = N_t diag(rho, C^-1) - [0 N_x.; N_x.^T 0].
void add_inflow(const Cell& cell, int facet, TermSum& terms) {
  const int D = cell.disc.dimension;
  const Vector covector = facet_covector(cell.geometry, D, facet);
  for (int q = 0; q < cell.disc.facet_rule.num_points(); ++q) {
    const double weight = cell.disc.facet_rule.weights[q];
    const PointState state = cell.state_on(facet, q);
    for (int i = 0; i < D; ++i) {
      Row on_velocity = sum(covector[D] * cell.material.density, state.velocity[i], 0, state.velocity[i]);
      for (int j = 0; j < D; ++j) on_velocity = sum(1, on_velocity, -covector[j], state.stress[i * D + j]);
      terms.add(-weight, on_velocity, state.velocity[i]);
      for (int j = 0; j < D; ++j)
        terms.add(-weight, sum(covector[D], state.strain[i * D + j], -covector[j], state.velocity[i]),
                  state.stress[i * D + j]);
    }
  }
}

/// Absorbing side: (vhat + Z^-1 shat) . (s + Z v) / 2, by the normal part and the rest of velocity and traction.
void add_absorbing(const Cell& cell, int facet, TermSum& terms) {
  const int D = cell.disc.dimension;
  const Vector covector = facet_covector(cell.geometry, D, facet);
  double area = 0;
  for (int j = 0; j < D; ++j) area += covector[j] * covector[j];
  area = std::sqrt(area);
  for (int q = 0; q < cell.disc.facet_rule.num_points(); ++q) {
    const double half_weight = 0.5 * area * cell.disc.facet_rule.weights[q];
    const PointState state = cell.state_on(facet, q);
    Rows traction(D, Row(cell.disc.num_unknowns, 0.0));
    Row normal_velocity(cell.disc.num_unknowns, 0.0), normal_traction = normal_velocity;
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) traction[i] = sum(1, traction[i], covector[j] / area, state.stress[i * D + j]);
      normal_velocity = sum(1, normal_velocity, covector[i] / area, state.velocity[i]);
      normal_traction = sum(1, normal_traction, covector[i] / area, traction[i]);
    }
    const auto add = [&](double impedance, const Row& v, const Row& s) {
      terms.add(half_weight, sum(1, v, 1 / impedance, s), sum(1, s, impedance, v));
    };
    add(cell.material.density * cell.material.dilatational_speed(), normal_velocity, normal_traction);
    for (int i = 0; i < D; ++i)
      add(cell.material.density * cell.material.shear_speed(),
          sum(1, state.velocity[i], -covector[i] / area, normal_velocity),
          sum(1, traction[i], -covector[i] / area, normal_traction));
  }
}

void add_rigid(const Cell& cell, TermSum& terms) {
  const std::vector<EntryFacet> entries = entry_facets(cell.disc, cell.element);
  for (const std::vector<Rows>& mode : rigid_modes(cell.disc, cell.element, entries)) {
    Row moments(cell.disc.num_unknowns, 0.0);
    for (std::size_t f = 0; f < entries.size(); ++f)
      for (int q = 0; q < cell.disc.facet_rule.num_points(); ++q) {
        const PointState state = cell.state_on(entries[f].facet, q);
        for (int i = 0; i < cell.disc.dimension; ++i)
          moments = sum(1, moments, entries[f].weight * cell.disc.facet_rule.weights[q] * mode[f][q][i],
                        state.displacement[i]);
      }
    terms.add(1, moments, moments);
  }
}

}  // namespace

std::vector<double> reference_cell_matrix(const PatchBatch& batch, int space_dimension, int degree, int element) {
  const Discretization disc(space_dimension, degree);
  const ElementDescriptor& descriptor = batch.elements[element];
  const Cell cell{disc, descriptor, batch.materials[descriptor.material],
                  element_geometry(descriptor, space_dimension)};
  TermSum terms(disc.num_unknowns);
  add_volume(cell, terms);
  for (int facet = 0; facet <= space_dimension + 1; ++facet) {
    if (descriptor.facet_kind[facet] == FacetKind::inflow) add_inflow(cell, facet, terms);
    if (descriptor.facet_kind[facet] == FacetKind::boundary) add_absorbing(cell, facet, terms);
  }
  add_rigid(cell, terms);
  return terms.take();
}

}  // namespace tentpole
