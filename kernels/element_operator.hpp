#pragma once

#include <cmath>

#include "common/status.hpp"
#include "kernels/inclined_facet.hpp"
#include "kernels/patch_batch.hpp"
#include "kernels/reference_tables.hpp"

namespace tentpole {

/// Coefficients of one vertical facet of an element. Components c run over the facet's frame e_c = (n, t..), which both
/// neighbours build from the same corners; n may point inwards (sign = -1). For dof (i, a) and reference derivative l
///   v_c = velocity[c][i][l] d_l phi_a,   s_c = traction[c][i][l] d_l phi_a (traction on the element's own outward
///   normal).
template <int D>
struct VerticalFacet {
  int facet;                   ///< local facet number
  int port;                    ///< index among the element's interior facets, or none on the boundary
  BoundaryKind kind[D];        ///< of each component, boundary facets only
  std::int32_t boundary_data;  ///< offset into prescribed, or none
  double measure;              ///< |F|, area times duration [scaled]
  double sign;                 ///< the own outward normal is sign e_0
  double frame[D][D];          ///< [c][i]: components of e_c
  double impedance[D];         ///< Z_c = rho c_p, rho c_s of this side
  double outer_impedance[D];   ///< of the neighbour
  double velocity[D][D][D + 1];
  double traction[D][D][D + 1];
};

/// A facet of the old or the new front. The rigid modes carry the zero-energy part of the weak form (below).
template <int D>
struct FrontFacet {
  int facet;
  double covector[D + 1];  ///< N dA, outward: N_t < 0 below, N_t > 0 above the element
};

/// The part of the rigid modes that lives on one facet with N_t < 0. The translations and infinitesimal rotations of an
/// element are orthonormal in the sum over these facets of |N_t| times the mean product; mode [r] on the facet is
/// modes[r][i][m] chi_m / root, root = sqrt(|N_t|).
template <int D>
struct RigidFacet {
  static constexpr int num_rigid = D + D * (D - 1) / 2;
  int facet;
  double root;
  double modes[num_rigid][D][D + 1];
};

/// One element's geometry and material, contracted so that all later loops are small factors times reference tables.
template <int D>
struct ElementOperator {
  static constexpr int d = D + 1, num_rigid = RigidFacet<D>::num_rigid;
  Status status;  ///< of its own construction
  double density, lambda, mu;
  double determinant;             ///< |det J|
  double inverse_jacobian[d][d];  ///< [l][j] = d xi_l / d x_j, j = D is time
  int num_inflow, num_outflow, num_rigid_facets, num_vertical, num_inclined, num_ports;
  FrontFacet<D> inflow[d + 1];
  FrontFacet<D> outflow[d + 1];
  RigidFacet<D> rigid[d + 1];  ///< inflow facets first, in their order, then inclined facets with N_t < 0
  VerticalFacet<D> vertical[d];
  InclinedFacet<D> inclined[InclinedFacet<D>::max_per_element];

  double time_slope(int l) const { return inverse_jacobian[l][D]; }
};

/// Inverse of a d x d matrix by Gauss-Jordan elimination with pivoting; returns |det|, 0 when singular.
template <int d>
inline double invert(const double (&matrix)[d][d], double (&inverse)[d][d]) {
  double work[d][d];
  for (int i = 0; i < d; ++i)
    for (int j = 0; j < d; ++j) {
      work[i][j] = matrix[i][j];
      inverse[i][j] = i == j;
    }
  double determinant = 1;
  for (int column = 0; column < d; ++column) {
    int pivot = column;
    for (int i = column + 1; i < d; ++i)
      if (fabs(work[i][column]) > fabs(work[pivot][column])) pivot = i;
    if (!(fabs(work[pivot][column]) > 0)) return 0;
    for (int j = 0; j < d; ++j) {
      const double keep = work[column][j], keep_inverse = inverse[column][j];
      work[column][j] = work[pivot][j];
      work[pivot][j] = keep;
      inverse[column][j] = inverse[pivot][j];
      inverse[pivot][j] = keep_inverse;
    }
    const double scale = 1 / work[column][column];
    determinant *= work[column][column];
    for (int j = 0; j < d; ++j) {
      work[column][j] *= scale;
      inverse[column][j] *= scale;
    }
    for (int i = 0; i < d; ++i) {
      if (i == column) continue;
      const double factor = work[i][column];
      for (int j = 0; j < d; ++j) {
        work[i][j] -= factor * work[column][j];
        inverse[i][j] -= factor * inverse[column][j];
      }
    }
  }
  return fabs(determinant);
}

/// Gradient of the barycentric coordinate of a corner: row corner - 1 of J^-1, corner 0 minus the sum of all rows.
template <int D>
inline void barycentric_gradient(const ElementOperator<D>& op, int corner, double (&gradient)[D + 1]) {
  for (int j = 0; j <= D; ++j) {
    gradient[j] = 0;
    if (corner > 0) {
      gradient[j] = op.inverse_jacobian[corner - 1][j];
    } else {
      for (int l = 0; l <= D; ++l) gradient[j] -= op.inverse_jacobian[l][j];
    }
  }
}

/// Outward N dA of the facet opposite a corner: - grad(lambda) |det J| / D!.
template <int D>
inline void facet_covector(const ElementOperator<D>& op, int corner, double (&covector)[D + 1]) {
  constexpr double inverse_factorial = D == 1 ? 1.0 : (D == 2 ? 0.5 : 1.0 / 6.0);
  barycentric_gradient<D>(op, corner, covector);
  for (int j = 0; j <= D; ++j) covector[j] *= -op.determinant * inverse_factorial;
}

/// Frame of a vertical facet from the spatial parts of its first D corners in the listed order, identical on both
/// sides. In a tent element these are the corners on the front; in a general element all corners are vertices of the
/// front, so that they are apart in space and span the vertical facet's shadow (D <= 2).
template <int D>
inline void facet_frame(const ElementDescriptor& element, int facet, double (&frame)[D][D]) {
  int corners[D];
  for (int corner = 0, count = 0; count < D; ++corner)
    if (corner != facet) corners[count++] = corner;
  if constexpr (D == 1) {
    frame[0][0] = 1;
  } else if constexpr (D == 2) {
    const double x = element.corner[corners[1]][0] - element.corner[corners[0]][0];
    const double y = element.corner[corners[1]][1] - element.corner[corners[0]][1];
    const double length = sqrt(x * x + y * y);
    frame[1][0] = x / length, frame[1][1] = y / length;
    frame[0][0] = frame[1][1], frame[0][1] = -frame[1][0];
  } else {
    double e[2][3];
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i < 3; ++i) e[side][i] = element.corner[corners[side + 1]][i] - element.corner[corners[0]][i];
    double normal[3] = {e[0][1] * e[1][2] - e[0][2] * e[1][1], e[0][2] * e[1][0] - e[0][0] * e[1][2],
                        e[0][0] * e[1][1] - e[0][1] * e[1][0]};
    const double area = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    const double length = sqrt(e[0][0] * e[0][0] + e[0][1] * e[0][1] + e[0][2] * e[0][2]);
    for (int i = 0; i < 3; ++i) {
      frame[0][i] = normal[i] / area;
      frame[1][i] = e[0][i] / length;
    }
    for (int i = 0; i < 3; ++i)
      frame[2][i] = frame[0][(i + 1) % 3] * frame[1][(i + 2) % 3] - frame[0][(i + 2) % 3] * frame[1][(i + 1) % 3];
  }
}

template <int D>
inline void impedances(const Material& material, double (&impedance)[D]) {
  impedance[0] = material.density * material.dilatational_speed();
  for (int c = 1; c < D; ++c) impedance[c] = material.density * material.shear_speed();
}

/// Velocity and own-normal traction of each frame component as coefficients of the reference derivatives:
/// v_c = e_c . u_t, s_c = sign e_c . sigma(u) n.
template <int D>
inline void facet_coefficients(const ElementOperator<D>& op, double sign, VerticalFacet<D>& facet) {
  const double(&normal)[D] = facet.frame[0];
  for (int l = 0; l <= D; ++l) {
    const double* gradient = op.inverse_jacobian[l];
    double along_normal = 0;
    for (int i = 0; i < D; ++i) along_normal += gradient[i] * normal[i];
    for (int c = 0; c < D; ++c) {
      double along_frame = 0;
      for (int i = 0; i < D; ++i) along_frame += gradient[i] * facet.frame[c][i];
      for (int i = 0; i < D; ++i) {
        facet.velocity[c][i][l] = facet.frame[c][i] * gradient[D];
        facet.traction[c][i][l] = sign * (op.mu * (facet.frame[c][i] * along_normal + normal[i] * along_frame) +
                                          (c == 0 ? op.lambda * gradient[i] : 0.0));
      }
    }
  }
}

/// Position on one facet in its chi modes, relative to corner 0 of the element.
template <int D>
inline void facet_position(const ElementDescriptor& element, const ReferenceTablesView& tables, int facet,
                           double (&position)[D][D + 1]) {
  constexpr int d = D + 1;
  for (int i = 0; i < D; ++i)
    for (int m = 0; m < d; ++m) position[i][m] = 0;
  for (int corner = 0, listed = 0; corner <= d; ++corner) {
    if (corner == facet) continue;
    const double* modes = tables.corner_modes + listed++ * d;
    for (int i = 0; i < D; ++i)
      for (int m = 0; m < d; ++m) position[i][m] += (element.corner[corner][i] - element.corner[0][i]) * modes[m];
  }
}

/// Rigid modes of one element over all its facets with N_t < 0: translations, then rotations about the |N_t|-weighted
/// centroid, which are orthogonal to them, by modified Gram-Schmidt in the concatenated chi modes of the facets.
template <int D>
inline void build_rigid_modes(const ElementDescriptor& element, const ReferenceTablesView& tables,
                              ElementOperator<D>& op) {
  constexpr int d = D + 1, num_rigid = ElementOperator<D>::num_rigid;
  double position[d + 1][D][d], total = 0, centroid[D] = {};
  op.num_rigid_facets = 0;
  const auto add = [&](int facet, double time_part) {
    const int f = op.num_rigid_facets++;
    op.rigid[f].facet = facet;
    op.rigid[f].root = sqrt(-time_part);
    total -= time_part;
    facet_position<D>(element, tables, facet, position[f]);
    for (int i = 0; i < D; ++i) centroid[i] -= time_part * position[f][i][0];
  };
  for (int f = 0; f < op.num_inflow; ++f) add(op.inflow[f].facet, op.inflow[f].covector[D]);
  for (int f = 0; f < op.num_inclined; ++f)
    if (op.inclined[f].time_part < 0) {
      op.inclined[f].rigid = op.num_rigid_facets;
      add(op.inclined[f].facet, op.inclined[f].time_part);
    }
  const double scale = 1 / sqrt(total);
  for (int f = 0; f < op.num_rigid_facets; ++f) {
    RigidFacet<D>& rigid = op.rigid[f];
    for (int r = 0; r < num_rigid; ++r)
      for (int i = 0; i < D; ++i)
        for (int m = 0; m < d; ++m) rigid.modes[r][i][m] = r == i && m == 0 ? rigid.root * scale : 0.0;
    for (int i = 0; i < D; ++i) position[f][i][0] -= centroid[i] / total;
    int rotation = D;
    for (int i = 0; i < D; ++i)
      for (int j = i + 1; j < D; ++j, ++rotation)
        for (int m = 0; m < d; ++m) {
          rigid.modes[rotation][i][m] = -rigid.root * position[f][j][m];
          rigid.modes[rotation][j][m] = rigid.root * position[f][i][m];
        }
  }
  const auto product = [&](int r, int s) {
    double sum = 0;
    for (int f = 0; f < op.num_rigid_facets; ++f)
      for (int i = 0; i < D; ++i)
        for (int m = 0; m < d; ++m) sum += op.rigid[f].modes[r][i][m] * op.rigid[f].modes[s][i][m];
    return sum;
  };
  for (int r = D; r < num_rigid; ++r) {
    for (int s = D; s < r; ++s) {
      const double overlap = product(r, s);
      for (int f = 0; f < op.num_rigid_facets; ++f)
        for (int i = 0; i < D; ++i)
          for (int m = 0; m < d; ++m) op.rigid[f].modes[r][i][m] -= overlap * op.rigid[f].modes[s][i][m];
    }
    const double factor = 1 / sqrt(product(r, r));
    for (int f = 0; f < op.num_rigid_facets; ++f)
      for (int i = 0; i < D; ++i)
        for (int m = 0; m < d; ++m) op.rigid[f].modes[r][i][m] *= factor;
  }
}

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
  // depend on damage (kernels/fracture_facet.hpp).
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
