#pragma once

#include "kernels/formulation/one_field/element_ports.hpp"
#include "kernels/formulation/one_field/facet_weights.hpp"

namespace tentpole {

/// Thin factors of one element in scratch: volume term D_t H and rigid modes.
struct VolumeFactors {
  double* time_derivative;  ///< [a][q] = sum_l J^-1_lt int d_l phi_a phi_q, degree k - 2
  double* curvature;        ///< [i, j][q][b] of |det J| (rho v_t - div sigma), stride basis_stride
  double* rigid;            ///< [rigid][i][a], stride basis_stride

  static long size(const ReferenceTablesView& tables) {
    const int dimension = tables.dimension, num_rigid = dimension * (dimension + 1) / 2;
    return static_cast<long>(tables.num_basis) * tables.num_curvature_modes +
           static_cast<long>(dimension) * tables.basis_stride *
               (static_cast<long>(dimension) * tables.num_curvature_modes + num_rigid);
  }
  static VolumeFactors at(double* scratch, const ReferenceTablesView& tables) {
    VolumeFactors factors;
    factors.time_derivative = scratch;
    factors.curvature = scratch + static_cast<long>(tables.num_basis) * tables.num_curvature_modes;
    factors.rigid = factors.curvature + static_cast<long>(tables.dimension) * tables.dimension *
                                            tables.num_curvature_modes * tables.basis_stride;
    return factors;
  }
};

/// Weight of d_l d_l' u_j (l <= l') in component i of rho u_tt - div sigma.
template <int D>
inline double volume_weight(const ElementOperator<D>& op, int i, int j, int l, int k) {
  const double *g = op.inverse_jacobian[l], *h = op.inverse_jacobian[k];
  double value = -0.5 * (op.lambda + op.mu) * (g[i] * h[j] + h[i] * g[j]);
  if (i == j) {
    double g_h = 0;
    for (int p = 0; p < D; ++p) g_h += g[p] * h[p];
    value += op.density * g[D] * h[D] - op.mu * g_h;
  }
  return (l == k ? 1 : 2) * value;
}

/// Row a of the factors that belong to a test function: D_t and the rigid modes.
template <int D>
inline void build_test_factors(const ElementOperator<D>& op, const ReferenceTablesView& tables, int a,
                               const VolumeFactors& factors) {
  constexpr int d = D + 1;
  const int num_basis = tables.num_basis, stride = tables.basis_stride, num_modes = tables.num_curvature_modes;
  for (int q = 0; q < num_modes; ++q) {
    double sum = 0;
    for (int l = 0; l < d; ++l)
      sum += op.time_slope(l) * tables.volume_derivative[(l * num_basis + a) * tables.num_volume_modes + q];
    factors.time_derivative[a * num_modes + q] = sum;
  }
  double moment[ElementOperator<D>::num_rigid][D] = {};
  for (int f = 0; f < op.num_rigid_facets; ++f) add_rigid_moments<D>(op.rigid[f], tables, a, moment);
  for (int rigid = 0; rigid < op.num_rigid; ++rigid)
    for (int i = 0; i < D; ++i) factors.rigid[(rigid * D + i) * stride + a] = moment[rigid][i];
}

/// H of one pair of components (i, j) = component.
template <int D>
inline void build_curvature_factor(const ElementOperator<D>& op, const ReferenceTablesView& tables, int component,
                                   const VolumeFactors& factors) {
  constexpr int d = D + 1, num_pairs = d * (d + 1) / 2;
  const int size = tables.num_curvature_modes * tables.basis_stride;
  double weight[num_pairs];
  for (int l = 0, pair = 0; l < d; ++l)
    for (int k = l; k < d; ++k, ++pair)
      weight[pair] = op.determinant * volume_weight<D>(op, component / D, component % D, l, k);
  double* out = factors.curvature + static_cast<long>(component) * size;
  for (int entry = 0; entry < size; ++entry) {
    double sum = 0;
    for (int pair = 0; pair < num_pairs; ++pair)
      sum += weight[pair] * tables.curvature[static_cast<long>(pair) * size + entry];
    out[entry] = sum;
  }
}

/// What the own matrix of one element is made of, and where it goes.
template <int D>
struct OwnMatrix {
  const ReferenceTablesView& tables;
  const FacetWeights<D>& weights;
  int num_facets;
  VolumeFactors factors;
  double* matrix;
  int stride;
};

/// Entries A[(i, a), (j, b0 .. b0 + width)] for all i, j: facet terms by reference tensors, volume and rigid parts by
/// their thin factors. V is double or Vector4, `count` of them side by side.
template <int D, class V, int count>
inline void matrix_strip(const OwnMatrix<D>& own, int a, int b0) {
  constexpr int width = sizeof(V) / sizeof(double);
  const ReferenceTablesView& tables = own.tables;
  const FacetWeights<D>& weights = own.weights;
  const VolumeFactors& factors = own.factors;
  const int stride = tables.basis_stride, num_modes = tables.num_curvature_modes;
  const auto load = [](const double* from) {
    if constexpr (width == 1)
      return *from;
    else
      return load4(from);
  };
  V sum[D * D][count] = {};
  for (int f = 0; f < own.num_facets; ++f) {
    const double* gram = weights.gram[f] + static_cast<long>(a) * weights.pairs * stride + b0;
    for (int pair = 0; pair < weights.pairs; ++pair, gram += stride)
      for (int s = 0; s < count; ++s) {
        const V table = load(gram + s * width);
        for (int ij = 0; ij < D * D; ++ij) sum[ij][s] += weights.weight[f][pair][ij] * table;
      }
  }
  for (int q = 0; q < num_modes; ++q) {
    const double derivative = factors.time_derivative[a * num_modes + q];
    for (int ij = 0; ij < D * D; ++ij)
      for (int s = 0; s < count; ++s)
        sum[ij][s] +=
            derivative * load(factors.curvature + (static_cast<long>(ij) * num_modes + q) * stride + b0 + s * width);
  }
  for (int rigid = 0; rigid < D * (D + 1) / 2; ++rigid)
    for (int j = 0; j < D; ++j)
      for (int s = 0; s < count; ++s) {
        const V column = load(factors.rigid + (rigid * D + j) * stride + b0 + s * width);
        for (int i = 0; i < D; ++i) sum[i * D + j][s] += factors.rigid[(rigid * D + i) * stride + a] * column;
      }
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      for (int s = 0; s < count; ++s) {
        double* to = own.matrix + static_cast<long>(i * tables.num_basis + a) * own.stride + j * tables.num_basis + b0 +
                     s * width;
        if constexpr (width == 1)
          *to = sum[i * D + j][s];
        else
          store4(to, sum[i * D + j][s]);
      }
}

/// Rows (i, a) of A for all i, in strips; the last strip overlaps its predecessor, so that no strip is partial.
template <int D>
inline void assemble_own_rows(const OwnMatrix<D>& own, int a) {
  constexpr int wide = D == 3 ? 4 : 8;
  const int num_basis = own.tables.num_basis;
  const int width = num_basis >= wide ? wide : (num_basis >= 4 ? 4 : 1);
  for (int begin = 0; begin < num_basis; begin += width) {
    const int b0 = begin + width <= num_basis ? begin : num_basis - width;
    if (width == 8)
      matrix_strip<D, Vector4, 2>(own, a, b0);
    else if (width == 4)
      matrix_strip<D, Vector4, 1>(own, a, b0);
    else
      matrix_strip<D, double, 1>(own, a, b0);
  }
}

/// One row of the padding: identity on the padded diagonal, zeros elsewhere in the padding, in the lower right block
/// and in the slots that a vertical facet of a general patch leaves unused. The column of b is not touched.
inline void clear_padding(const CondensedShape& shape, double* matrix, int row) {
  const int n = shape.num_unknowns, padded = shape.unknowns_padded, ports_end = padded + shape.num_amplitudes;
  double* entries = matrix + static_cast<long>(row) * shape.stride;
  const auto clear = [entries](int first, int last) {
    for (int column = first; column < last; ++column) entries[column] = 0;
  };
  const bool has_spare_slots = shape.amplitudes_per_port > shape.vertical_amplitudes;
  if (has_spare_slots) clear(row < n ? n : 0, ports_end);
  if (row < n) {
    clear(n, padded);
    clear(ports_end, shape.rows);
  } else {
    const bool amplitude_row = row >= padded && row < ports_end;
    clear(amplitude_row ? n : 0, shape.rows);
    if (row < padded) entries[row] = 1;
  }
}

}  // namespace tentpole
