#pragma once

#include <cmath>

#include "kernels/element/inclined_facet.hpp"
#include "kernels/element/patch_batch.hpp"

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

}  // namespace tentpole
