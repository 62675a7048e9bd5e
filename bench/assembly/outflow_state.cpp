#include "bench/assembly/outflow_state.hpp"

#include <algorithm>
#include <limits>

#include "kernels/element/principal_stress.hpp"
#include "kernels/element/simd.hpp"
#include "kernels/element/with_dimension.hpp"
#include "kernels/reference/point_state.reference.hpp"

namespace tentpole {
namespace {

/// Physical derivatives u_i,j (j = D: time) of the element's solution at a facet point.
template <int D>
void displacement_gradient(const CellTables& tables, const reference::Matrix& inverse, const double* table,
                           const double* coefficients, double (&gradient)[D][D + 1]) {
  for (int i = 0; i < D; ++i) {
    double along[D + 1];
    for (int l = 0; l <= D; ++l)
      along[l] = dot(table + l * tables.num_basis, coefficients + i * tables.num_basis, tables.num_basis);
    for (int j = 0; j <= D; ++j) {
      gradient[i][j] = 0;
      for (int l = 0; l <= D; ++l) gradient[i][j] += along[l] * inverse[l][j];
    }
  }
}

/// 1/2 w^T A_N w = N_t (rho v.v + sigma:E) / 2 - v.(sigma N_x); fills the stress.
template <int D>
double energy_density(const Material& material, const reference::Vector& covector, const double (&gradient)[D][D + 1],
                      double (&stress)[D][D]) {
  double trace = 0, energy = 0;
  for (int i = 0; i < D; ++i) trace += gradient[i][i];
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      stress[i][j] = material.mu * (gradient[i][j] + gradient[j][i]) + (i == j ? material.lambda * trace : 0);
  for (int i = 0; i < D; ++i) {
    const double velocity = gradient[i][D];
    energy += 0.5 * covector[D] * material.density * velocity * velocity;
    for (int j = 0; j < D; ++j)
      energy += 0.5 * covector[D] * stress[i][j] * gradient[i][j] - velocity * stress[i][j] * covector[j];
  }
  return energy;
}

template <int D>
OutflowState evaluate(const CellTables& tables, const PatchBatch& batch, int index, const double* coefficients) {
  const ElementDescriptor& element = batch.elements[index];
  const reference::Geometry geometry = reference::element_geometry(element, D);
  OutflowState state{0, -std::numeric_limits<double>::infinity()};
  for (int facet = 0; facet <= D + 1; ++facet) {
    if (element.facet_kind[facet] != FacetKind::outflow) continue;
    const reference::Vector covector = reference::facet_covector(geometry, D, facet);
    for (int point = 0; point < tables.num_facet_points(); ++point) {
      double gradient[D][D + 1], stress[D][D];
      displacement_gradient<D>(tables, geometry.inverse, tables.gradient_on_facet(facet, point), coefficients,
                               gradient);
      state.energy +=
          tables.facet_weight[point] * energy_density<D>(batch.materials[element.material], covector, gradient, stress);
      state.largest_principal_stress = std::max(state.largest_principal_stress, largest_principal<D>(stress));
    }
  }
  return state;
}

}  // namespace

OutflowState outflow_state(const CellTables& tables, const PatchBatch& batch, int element, const double* coefficients) {
  return with_dimension(tables.dimension, [&](auto D) { return evaluate<D>(tables, batch, element, coefficients); });
}

}  // namespace tentpole
