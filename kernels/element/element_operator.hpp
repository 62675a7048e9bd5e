#pragma once

#include "common/status.hpp"
#include "kernels/element/rigid_modes.hpp"

namespace tentpole {

template <int D>
inline void build_vertical_facet(const PatchBatch& batch, const ElementDescriptor& element, int facet,
                                 ElementOperator<D>& op) {
  VerticalFacet<D>& vertical = op.vertical[op.num_vertical++];
  vertical.facet = facet;
  facet_frame<D>(element, facet, vertical.frame);
  double covector[D + 1], along_normal = 0;
  facet_covector<D>(op, facet, covector);
  for (int i = 0; i < D; ++i) along_normal += covector[i] * vertical.frame[0][i];
  vertical.measure = fabs(along_normal);
  impedances<D>(batch.materials[element.material], vertical.impedance);
  vertical.sign = along_normal > 0 ? 1.0 : -1.0;
  facet_coefficients<D>(op, vertical.sign, vertical);
  if (element.facet_kind[facet] == FacetKind::boundary) {
    vertical.port = none;
    vertical.boundary_data = element.facet_data[facet];
    for (int c = 0; c < D; ++c) vertical.kind[c] = c == 0 ? element.normal_kind[facet] : element.tangential_kind[facet];
    return;
  }
  vertical.port = op.num_ports++;
  // A side of a fracture facet takes its incoming wave as if its own material went on: then the own block does not
  // depend on damage (kernels/fracture/fracture_facet.hpp).
  const bool fracture = element.facet_kind[facet] == FacetKind::fracture;
  const ElementDescriptor& neighbor = batch.elements[element.neighbor[facet]];
  impedances<D>(batch.materials[fracture ? element.material : neighbor.material], vertical.outer_impedance);
}

/// Adds a facet of the front; not_causal if it is steeper than 1 / c_p or not on its side of the element: `side` is the
/// sign of N_t.
template <int D>
inline Status add_front_facet(const ElementOperator<D>& op, double speed, double side, int facet,
                              FrontFacet<D>& front) {
  front.facet = facet;
  facet_covector<D>(op, facet, front.covector);
  double space = 0;
  for (int i = 0; i < D; ++i) space += front.covector[i] * front.covector[i];
  return side * front.covector[D] > speed * sqrt(space) ? Status::ok : Status::not_causal;
}

/// Whether the top of a tent stands straight above its bottom: its inner facets are then parallel to the time axis,
/// whatever rounding says about their normals (up to 1e-10 where tents are low).
template <int D>
inline bool is_straight_tent(const ElementDescriptor& element) {
  if (element.pole == none) return false;
  for (int i = 0; i < D; ++i)
    if (element.corner[D + 1][i] != element.corner[element.pole][i]) return false;
  return true;
}

/// Whether a facet with this normal counts as parallel to the time axis.
template <int D>
inline bool is_vertical(const double (&covector)[D + 1], double tolerance) {
  double square = 0;
  for (int j = 0; j <= D; ++j) square += covector[j] * covector[j];
  return fabs(covector[D]) <= tolerance * sqrt(square);
}

/// N dA of a facet that lists its corners ascending, from the edges of the facet alone: both sides get the same numbers
/// up to the sign, which makes it outward, and so agree on what is inclined and on the waves. D = 1 or 2.
template <int D>
inline void shared_covector(const ElementDescriptor& element, int facet, double (&covector)[D + 1]) {
  int corners[D + 1];
  for (int corner = 0, count = 0; corner <= D + 1; ++corner)
    if (corner != facet) corners[count++] = corner;
  double edge[D][D + 1], side = 0;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j <= D; ++j) edge[i][j] = element.corner[corners[i + 1]][j] - element.corner[corners[0]][j];
  if constexpr (D == 1) {
    covector[0] = edge[0][1], covector[1] = -edge[0][0];
  } else {
    for (int j = 0; j < 3; ++j)
      covector[j] = 0.5 * (edge[0][(j + 1) % 3] * edge[1][(j + 2) % 3] - edge[0][(j + 2) % 3] * edge[1][(j + 1) % 3]);
  }
  for (int j = 0; j <= D; ++j) side += covector[j] * (element.corner[facet][j] - element.corner[corners[0]][j]);
  if (side > 0)
    for (int j = 0; j <= D; ++j) covector[j] = -covector[j];
}

/// Adds a facet inside the patch or on the boundary of the domain.
template <int D>
inline Status add_inner_facet(const PatchBatch& batch, const ElementDescriptor& element, int facet,
                              ElementOperator<D>& op) {
  if (!is_straight_tent<D>(element)) {
    if constexpr (D == 3) {
      return Status::patch_not_general;
    } else {
      double covector[D + 1];
      shared_covector<D>(element, facet, covector);
      const bool may_incline = element.facet_kind[facet] == FacetKind::interior;
      if (!may_incline && !is_vertical<D>(covector, 1e-9)) return Status::boundary_not_vertical;
      if (may_incline && !is_vertical<D>(covector, 1e-13)) {
        InclinedFacet<D>& inclined = op.inclined[op.num_inclined++];
        inclined.facet = facet;
        inclined.port = op.num_ports++;
        inclined.rigid = none;
        build_inclined_facet<D>(batch.materials[element.material], op.inverse_jacobian, covector, inclined);
        return Status::ok;
      }
    }
  }
  build_vertical_facet<D>(batch, element, facet, op);
  return Status::ok;
}

/// Builds the operator of one element of a patch that is general or not (PatchDescriptor). Status: inverted_element,
/// not_causal, patch_not_general, boundary_not_vertical (common/status.hpp).
template <int D>
inline Status build_element_operator(const PatchBatch& batch, const ReferenceTablesView& tables, bool is_general,
                                     const ElementDescriptor& element, ElementOperator<D>& op) {
  constexpr int d = D + 1;
  if (!is_general && !is_straight_tent<D>(element)) return Status::patch_not_general;
  const Material& material = batch.materials[element.material];
  op.density = material.density, op.lambda = material.lambda, op.mu = material.mu;
  double jacobian[d][d];
  for (int l = 0; l < d; ++l)
    for (int j = 0; j < d; ++j) jacobian[j][l] = element.corner[l + 1][j] - element.corner[0][j];
  op.determinant = invert<d>(jacobian, op.inverse_jacobian);
  if (!(op.determinant > 0)) return Status::inverted_element;
  op.num_inflow = op.num_outflow = op.num_vertical = op.num_inclined = op.num_ports = 0;
  const double speed = material.dilatational_speed();
  for (int facet = 0; facet <= d; ++facet) {
    Status status = Status::ok;
    switch (element.facet_kind[facet]) {
      case FacetKind::inflow:
        status = add_front_facet<D>(op, speed, -1.0, facet, op.inflow[op.num_inflow++]);
        break;
      case FacetKind::outflow:
        status = add_front_facet<D>(op, speed, 1.0, facet, op.outflow[op.num_outflow++]);
        break;
      default:
        status = add_inner_facet<D>(batch, element, facet, op);
    }
    if (status != Status::ok) return status;
  }
  build_rigid_modes<D>(element, tables, op);
  return Status::ok;
}

}  // namespace tentpole
