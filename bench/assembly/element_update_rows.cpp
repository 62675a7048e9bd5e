// The rows that a quadrature point of each kind contributes (declared in element_updates.hpp).
#include <algorithm>

#include "bench/assembly/element_updates.hpp"

namespace tentpole {

using reference::Matrix;

ElementUpdates::RowScratch ElementUpdates::divide(double* scratch, int num_terms) const {
  const long n = tables_->num_unknowns, d = tables_->dimension + 1;
  double* test = scratch + d * tables_->num_basis;
  return {scratch, test, test + num_terms * n};
}

long ElementUpdates::scratch_size() const {
  const long n = tables_->num_unknowns, D = tables_->dimension, d = D + 1;
  return d * tables_->num_basis + d * n + D * d * n;
}

UpdateRows ElementUpdates::form(int update, double* scratch) const {
  const Segment& segment = segment_of(update);
  const int point = update - segment.first;
  switch (segment.kind) {
    case Kind::volume:
      return form_volume(point, scratch);
    case Kind::inflow:
      return form_inflow(segment.facet, point, scratch);
    case Kind::vertical:
      return form_vertical(segment.facet, point, scratch);
    case Kind::neighbor:
      return form_neighbor(segment.facet, point, scratch);
    default:
      return form_rigid();
  }
}

// d phi_a / d x_j = sum_l d xi_l / d x_j d_l phi_a
ElementUpdates::Gradient ElementUpdates::physical_gradient(const Matrix& inverse, const double* table,
                                                           double* out) const {
  const int d = tables_->dimension + 1, num_basis = tables_->num_basis;
  std::fill_n(out, d * num_basis, 0.0);
  for (int j = 0; j < d; ++j)
    for (int l = 0; l < d; ++l)
      for (int a = 0; a < num_basis; ++a) out[j * num_basis + a] += inverse[l][j] * table[l * num_basis + a];
  return {out, num_basis};
}

// vhat_i (rho u_i,tt - (lambda + mu) u_j,ji - mu u_i,jj)
UpdateRows ElementUpdates::form_volume(int point, double* scratch) const {
  const int D = tables_->dimension, d = D + 1, num_basis = tables_->num_basis, n = tables_->num_unknowns;
  const RowScratch rows = divide(scratch, 1);
  const Gradient gradient = physical_gradient(geometry_.inverse, tables_->gradient_in_volume(point), rows.gradient);
  for (int i = 0; i < D; ++i) std::copy_n(gradient.along(D), num_basis, rows.test + i * num_basis);
  std::fill_n(rows.trial, static_cast<long>(D) * n, 0.0);
  const double* hessian = tables_->hessian_in_volume(point);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      for (int l = 0, pair = 0; l < d; ++l)
        for (int m = l; m < d; ++m, ++pair) {
          const reference::Vector &g = geometry_.inverse[l], &h = geometry_.inverse[m];
          double weight = -0.5 * (material_.lambda + material_.mu) * (g[i] * h[j] + h[i] * g[j]);
          if (i == j) {
            weight += material_.density * g[D] * h[D];
            for (int p = 0; p < D; ++p) weight -= material_.mu * g[p] * h[p];
          }
          if (m > l) weight *= 2;
          double* trial = rows.trial + static_cast<long>(i) * n + j * num_basis;
          for (int b = 0; b < num_basis; ++b) trial[b] += weight * hessian[pair * num_basis + b];
        }
  return {num_basis, n, 1, tables_->volume_weight[point] * geometry_.determinant, rows.test, rows.trial, n};
}

// - what^T A_N w = vhat_i [- N_t rho v_i + (sigma N_x)_i]
//                + Ehat_ij [- N_t sigma_ij + lambda (v . N_x) delta_ij + mu (v_i N_j + v_j N_i)]
UpdateRows ElementUpdates::form_inflow(int facet, int point, double* scratch) const {
  const int D = tables_->dimension, num_basis = tables_->num_basis, n = tables_->num_unknowns, num_terms = D + 1;
  const RowScratch rows = divide(scratch, num_terms);
  const Gradient gradient =
      physical_gradient(geometry_.inverse, tables_->gradient_on_facet(facet, point), rows.gradient);
  for (int term = 0; term < num_terms; ++term)
    for (int i = 0; i < D; ++i) std::copy_n(gradient.along(term), num_basis, rows.test + term * n + i * num_basis);
  const reference::Vector& normal = covector_[facet];
  const double lambda = material_.lambda, mu = material_.mu;
  // Component (p, q) of sigma for the unknown (j, b).
  const auto stress = [&](int p, int q, int j, int b) {
    double value = p == q ? lambda * gradient.along(j)[b] : 0;
    if (p == j) value += mu * gradient.along(q)[b];
    if (q == j) value += mu * gradient.along(p)[b];
    return value;
  };
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      for (int b = 0; b < num_basis; ++b) {
        double* trial = rows.trial + static_cast<long>(i) * num_terms * n + j * num_basis + b;
        const double velocity = gradient.along(D)[b];
        double momentum = i == j ? -normal[D] * material_.density * velocity : 0;
        for (int p = 0; p < D; ++p) momentum += stress(i, p, j, b) * normal[p];
        trial[static_cast<long>(D) * n] = momentum;
        for (int p = 0; p < D; ++p) {
          double flux = -normal[D] * stress(i, p, j, b);
          if (i == p) flux += lambda * velocity * normal[j];
          if (i == j) flux += mu * velocity * normal[p];
          if (p == j) flux += mu * velocity * normal[i];
          trial[static_cast<long>(p) * n] = flux;
        }
      }
  return {
      num_basis, n, num_terms, tables_->facet_weight[point], rows.test, rows.trial, static_cast<long>(num_terms) * n};
}

double ElementUpdates::impedance(int component) const {
  return material_.density * (component == 0 ? material_.dilatational_speed() : material_.shear_speed());
}

// v_c + s_c / Z_c
ElementUpdates::FrameFactors ElementUpdates::test_factors() const {
  FrameFactors factors{};
  for (int c = 0; c < tables_->dimension; ++c) factors.velocity[c] = 1, factors.traction[c] = 1 / impedance(c);
  return factors;
}

// Interior (the same material beyond) and absorbing: (s + Z v) / 2; velocity: Z v; traction: s.
ElementUpdates::FrameFactors ElementUpdates::own_factors(int facet) const {
  FrameFactors factors{};
  for (int c = 0; c < tables_->dimension; ++c) {
    const BoundaryKind kind = element_->facet_kind[facet] == FacetKind::interior ? BoundaryKind::absorbing
                              : c == 0                                           ? element_->normal_kind[facet]
                                                                                 : element_->tangential_kind[facet];
    const double share = kind == BoundaryKind::absorbing ? 0.5 : 1.0;
    factors.velocity[c] = kind == BoundaryKind::traction ? 0 : share * impedance(c);
    factors.traction[c] = kind == BoundaryKind::velocity ? 0 : share;
  }
  return factors;
}

// v_c = e_c,j phi_b,t and s_c = lambda (e_c . n) phi_b,j + mu (e_c,j phi_b,n + n_j phi_b,c) for the unknown (j, b).
void ElementUpdates::frame_rows(int facet, const Gradient& gradient, const FrameFactors& factors, double* rows) const {
  const int D = tables_->dimension, num_basis = tables_->num_basis;
  const Matrix& frame = frame_[facet];
  for (int c = 0; c < D; ++c)
    for (int j = 0; j < D; ++j)
      for (int b = 0; b < num_basis; ++b) {
        double along_normal = 0, along_component = 0;
        for (int p = 0; p < D; ++p) {
          along_normal += frame[0][p] * gradient.along(p)[b];
          along_component += frame[c][p] * gradient.along(p)[b];
        }
        const double traction = (c == 0 ? material_.lambda * gradient.along(j)[b] : 0) +
                                material_.mu * (frame[c][j] * along_normal + frame[0][j] * along_component);
        rows[static_cast<long>(c) * tables_->num_unknowns + j * num_basis + b] =
            factors.velocity[c] * frame[c][j] * gradient.along(D)[b] + factors.traction[c] * traction;
      }
}

/// One term per component of the frame, the same for all components of the test.
UpdateRows ElementUpdates::facet_update(int facet, int point, const RowScratch& rows) const {
  return {tables_->num_basis,
          tables_->num_unknowns,
          tables_->dimension,
          area_[facet] * tables_->facet_weight[point],
          rows.test,
          rows.trial,
          0};
}

UpdateRows ElementUpdates::form_vertical(int facet, int point, double* scratch) const {
  const int D = tables_->dimension;
  const RowScratch rows = divide(scratch, D);
  const Gradient gradient =
      physical_gradient(geometry_.inverse, tables_->gradient_on_facet(facet, point), rows.gradient);
  frame_rows(facet, gradient, test_factors(), rows.test);
  frame_rows(facet, gradient, own_factors(facet), rows.trial);
  return facet_update(facet, point, rows);
}

// The neighbour's trial, with its stress on our normal: - (s + Z v) / 2.
UpdateRows ElementUpdates::form_neighbor(int facet, int point, double* scratch) const {
  const int D = tables_->dimension;
  const RowScratch rows = divide(scratch, D);
  frame_rows(facet, physical_gradient(geometry_.inverse, tables_->gradient_on_facet(facet, point), rows.gradient),
             test_factors(), rows.test);
  const double* table = tables_->gradient_on_facet(element_->neighbor_facet[facet], point);
  FrameFactors incoming = own_factors(facet);
  for (int c = 0; c < D; ++c) incoming.velocity[c] *= -1, incoming.traction[c] *= -1;
  frame_rows(facet, physical_gradient(neighbor_inverse_[facet], table, rows.gradient), incoming, rows.trial);
  return facet_update(facet, point, rows);
}

UpdateRows ElementUpdates::form_rigid() const {
  const int n = tables_->num_unknowns;
  return {tables_->num_basis,    n, num_symmetric(tables_->dimension), 1.0, rigid_moments_.data(),
          rigid_moments_.data(), 0};
}

}  // namespace tentpole
