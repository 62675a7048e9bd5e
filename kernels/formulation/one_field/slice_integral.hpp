#pragma once

#include "kernels/element/basis_recurrence.hpp"
#include "kernels/element/patch_batch.hpp"
#include "kernels/element/reference_tables.hpp"
#include "kernels/element/simd.hpp"
#include "kernels/element/slice_tables.hpp"

namespace tentpole {

/// Velocity and strain of one element in the orthonormal basis of degree k - 1 of its reference simplex.
template <int D>
struct FieldModes {
  static constexpr int num_fields = D + num_symmetric(D);
  static constexpr int max_modes = num_polynomials(D + 1, max_degree - 1);
  double mode[max_modes][num_fields];  ///< [q]: v_i, then E in the order of symmetric_index, tensor components
};

/// modes of d_l u_i = sum_a c_ia int d_l phi_a phi_q, exact because the basis is orthonormal; contracted with J^-1.
template <int D>
inline void field_modes(const ReferenceTablesView& tables, const double* coefficients, const double* inverse_jacobian,
                        FieldModes<D>& fields) {
  constexpr int d = D + 1;
  for (int q = 0; q < tables.num_volume_modes; ++q)
    for (int field = 0; field < fields.num_fields; ++field) fields.mode[q][field] = 0;
  for (int l = 0; l < d; ++l)
    for (int i = 0; i < D; ++i) {
      double derivative[FieldModes<D>::max_modes];
      for (int q = 0; q < tables.num_volume_modes; ++q) derivative[q] = 0;
      for (int degree = 1; degree <= tables.degree; ++degree) {
        // Derivatives of functions of this degree have modes of lower degree only.
        const int first = num_polynomials(d, degree - 1), last = num_polynomials(d, degree);
        for (int a = first; a < last; ++a) {
          const double coefficient = coefficients[i * tables.num_basis + a];
          const double* product =
              tables.volume_derivative + (static_cast<long>(l) * tables.num_basis + a) * tables.num_volume_modes;
          for (int q = 0; q < first; ++q) derivative[q] += coefficient * product[q];
        }
      }
      const double* slope = inverse_jacobian + l * d;
      for (int q = 0; q < tables.num_volume_modes; ++q) {
        fields.mode[q][i] += slope[D] * derivative[q];
        for (int j = 0; j < D; ++j)
          fields.mode[q][D + symmetric_index(D, i, j)] += (i == j ? 1.0 : 0.5) * slope[j] * derivative[q];
      }
    }
}

/// Energies on a slice.
struct SliceEnergies {
  double kinetic = 0;
  double strain = 0;
};

/// Corners of an element on the two sides of a slice; the smaller side is the slow one.
struct SliceSides {
  int num_slow;  ///< 1 or 2; 0 where the slice misses the element
  int slow[max_dimension + 2];
  int fast[max_dimension + 2];
};

template <int D>
inline SliceSides slice_sides(const ElementDescriptor& element, double time) {
  double lowest = element.corner[0][D];
  for (int corner = 1; corner < D + 2; ++corner)
    lowest = element.corner[corner][D] < lowest ? element.corner[corner][D] : lowest;
  SliceSides sides{};
  int num_below = 0, num_above = 0, below[D + 2], above[D + 2];
  for (int corner = 0; corner < D + 2; ++corner) {
    const double at = element.corner[corner][D];
    if (at < time || (time == lowest && at == time)) {
      below[num_below++] = corner;
    } else {
      above[num_above++] = corner;
    }
  }
  const bool swap = num_above < num_below;
  sides.num_slow = swap ? num_above : num_below;
  for (int i = 0; i < num_below; ++i) (swap ? sides.fast : sides.slow)[i] = below[i];
  for (int i = 0; i < num_above; ++i) (swap ? sides.slow : sides.fast)[i] = above[i];
  return sides;
}

/// Where the edges from slow to fast corners meet the slice.
template <int D, int S>
struct SliceCut {
  static constexpr int F = D + 2 - S;
  double fraction[S][F];      ///< of the way from slow corner i to fast corner j
  double across[F][D];        ///< S = 2: cut (1, j) minus cut (0, j)
  double along[S][F - 1][D];  ///< cut (i, j + 1) minus cut (i, 0)
};

template <int D, int S>
inline void cut_edges(const ElementDescriptor& element, const SliceSides& sides, double time, SliceCut<D, S>& cut) {
  constexpr int F = SliceCut<D, S>::F;
  double position[S][F][D];  // relative to the first slow corner, so that small slices keep their digits
  for (int i = 0; i < S; ++i)
    for (int j = 0; j < F; ++j) {
      const double *low = element.corner[sides.slow[i]], *high = element.corner[sides.fast[j]];
      const double fraction = (time - low[D]) / (high[D] - low[D]);
      cut.fraction[i][j] = fraction;
      for (int axis = 0; axis < D; ++axis)
        position[i][j][axis] = (low[axis] - element.corner[sides.slow[0]][axis]) + fraction * (high[axis] - low[axis]);
    }
  for (int axis = 0; axis < D; ++axis) {
    for (int j = 0; j < F; ++j) cut.across[j][axis] = position[S - 1][j][axis] - position[0][j][axis];
    for (int i = 0; i < S; ++i)
      for (int j = 1; j < F; ++j) cut.along[i][j - 1][axis] = position[i][j][axis] - position[i][0][axis];
  }
}

template <int D>
inline Vector4 determinant(const Vector4 (&m)[D][D]) {
  if constexpr (D == 1) {
    return m[0][0];
  } else if constexpr (D == 2) {
    return m[0][0] * m[1][1] - m[0][1] * m[1][0];
  } else {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  }
}

/// Reference coordinates of a block of slice points and their weights times the (signed) Jacobian of the slice.
template <int D, int S>
inline void slice_points(const SliceCut<D, S>& cut, const SliceSides& sides, const double* points, Vector4 (&xi)[D + 1],
                         Vector4& weight) {
  constexpr int F = SliceCut<D, S>::F;
  Vector4 r[S], f[F], barycentric[D + 2], column[D][D];
  for (int i = 0; i < S; ++i) r[i] = load4(points + 4 * i);
  for (int j = 0; j < F; ++j) f[j] = load4(points + 4 * (S + j));
  for (int i = 0; i < S; ++i) {
    Vector4 up{};
    for (int j = 0; j < F; ++j) up += cut.fraction[i][j] * f[j];
    barycentric[sides.slow[i]] = r[i] - r[i] * up;
  }
  for (int j = 0; j < F; ++j) {
    Vector4 up{};
    for (int i = 0; i < S; ++i) up += cut.fraction[i][j] * r[i];
    barycentric[sides.fast[j]] = f[j] * up;
  }
  for (int l = 0; l <= D; ++l) xi[l] = barycentric[l + 1];
  for (int axis = 0; axis < D; ++axis) {
    if constexpr (S == 2) {
      column[0][axis] = cut.across[0][axis] * f[0];
      for (int j = 1; j < F; ++j) column[0][axis] += cut.across[j][axis] * f[j];
    }
    for (int j = 0; j + 1 < F; ++j) {
      column[S - 1 + j][axis] = cut.along[0][j][axis] * r[0];
      for (int i = 1; i < S; ++i) column[S - 1 + j][axis] += cut.along[i][j][axis] * r[i];
    }
  }
  weight = load4(points + 4 * (S + F)) * determinant<D>(column);
}

/// Adds 1/2 rho v.v and 1/2 sigma:E of a block of points with these fields, weighted.
template <int D>
inline void add_energies(const Material& material, const Vector4 (&field)[FieldModes<D>::num_fields], Vector4 weight,
                         Vector4& kinetic, Vector4& strain) {
  Vector4 velocity_square{}, trace{}, strain_square{};
  for (int i = 0; i < D; ++i) {
    velocity_square += field[i] * field[i];
    trace += field[D + i];
    strain_square += field[D + i] * field[D + i];
  }
  for (int shear = 2 * D; shear < FieldModes<D>::num_fields; ++shear)
    strain_square += 2.0 * field[shear] * field[shear];
  kinetic += weight * (0.5 * material.density) * velocity_square;
  strain += weight * (0.5 * material.lambda * (trace * trace) + material.mu * strain_square);
}

/// Energies on one slice with S corners on its slow side.
template <int D, int S>
inline SliceEnergies slice_integral(const SliceTablesView& tables, const ElementDescriptor& element,
                                    const Material& material, const FieldModes<D>& fields, const SliceSides& sides,
                                    double time) {
  constexpr int num_fields = FieldModes<D>::num_fields, num_entries = D + 3,
                max_factors = max_degree * (max_degree + 1) / 2;
  SliceCut<D, S> cut;
  cut_edges<D, S>(element, sides, time, cut);
  Vector4 kinetic{}, strain{};
  for (int block = 0; block < tables.num_blocks[S - 1]; ++block) {
    Vector4 xi[D + 1], weight, factors[(D + 1) * max_factors], field[num_fields] = {};
    slice_points<D, S>(cut, sides, tables.points[S - 1] + block * num_entries * 4, xi, weight);
    basis_factors<D + 1>(tables.recurrence, xi, factors);
    for_each_basis_function<D + 1>(tables.recurrence, factors, [&](int q, const Vector4& phi) {
      for (int i = 0; i < num_fields; ++i) field[i] += fields.mode[q][i] * phi;
    });
    add_energies<D>(material, field, weight, kinetic, strain);
  }
  // The Jacobian has one sign on the whole slice, that of the order of the corners.
  const double kinetic_sum = (kinetic[0] + kinetic[1]) + (kinetic[2] + kinetic[3]);
  const double strain_sum = (strain[0] + strain[1]) + (strain[2] + strain[3]);
  return {kinetic_sum < 0 ? -kinetic_sum : kinetic_sum, strain_sum < 0 ? -strain_sum : strain_sum};
}

/// Energies of an element on the slice t = time; 0 where the slice misses it.
template <int D>
inline SliceEnergies slice_energies(const SliceTablesView& tables, const ElementDescriptor& element,
                                    const Material& material, const FieldModes<D>& fields, double time) {
  const SliceSides sides = slice_sides<D>(element, time);
  if (sides.num_slow == 1) return slice_integral<D, 1>(tables, element, material, fields, sides, time);
  if constexpr (D > 1)
    if (sides.num_slow == 2) return slice_integral<D, 2>(tables, element, material, fields, sides, time);
  return {};
}

}  // namespace tentpole
