#pragma once

#include "kernels/element_ports.hpp"
#include "kernels/facet_weights.hpp"

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

template <int D, class Lanes>
inline void build_volume_factors(const ElementOperator<D>& op, const ReferenceTablesView& tables,
                                 const VolumeFactors& factors, const Lanes& lanes) {
  constexpr int d = D + 1;
  const int num_basis = tables.num_basis, stride = tables.basis_stride, num_modes = tables.num_curvature_modes;
  for (int a = lanes.first(); a < num_basis; a += lanes.count()) {
    for (int q = 0; q < num_modes; ++q) {
      double sum = 0;
      for (int l = 0; l < d; ++l)
        sum += op.time_slope(l) * tables.volume_derivative[(l * num_basis + a) * tables.num_volume_modes + q];
      factors.time_derivative[a * num_modes + q] = sum;
    }
    for (int rigid = 0; rigid < op.num_rigid; ++rigid)
      for (int i = 0; i < D; ++i)
        factors.rigid[(rigid * D + i) * stride + a] = rigid_moment<D>(op, tables, rigid, i, a);
  }
  for (int component = lanes.first(); component < D * D; component += lanes.count()) {
    double weight[d * (d + 1) / 2];
    for (int l = 0, pair = 0; l < d; ++l)
      for (int k = l; k < d; ++k, ++pair)
        weight[pair] = op.determinant * volume_weight<D>(op, component / D, component % D, l, k);
    double* out = factors.curvature + static_cast<long>(component) * num_modes * stride;
    for (int entry = 0; entry < num_modes * stride; ++entry) {
      double sum = 0;
      for (int pair = 0; pair < d * (d + 1) / 2; ++pair)
        sum += weight[pair] * tables.curvature[static_cast<long>(pair) * num_modes * stride + entry];
      out[entry] = sum;
    }
  }
}

/// Entries A[(i, a), (j, b0 .. b0 + width)] for all i, j: facet terms by reference tensors, volume and rigid parts by
/// their thin factors. V is double or Vector4, `count` of them side by side.
template <int D, class V, int count>
inline void matrix_strip(const FacetWeights<D>& weights, const VolumeFactors& factors,
                         const ReferenceTablesView& tables, int a, int b0, double* matrix, int matrix_stride) {
  constexpr int width = sizeof(V) / sizeof(double);
  const int stride = tables.basis_stride, num_modes = tables.num_curvature_modes;
  const auto load = [](const double* from) {
    if constexpr (width == 1)
      return *from;
    else
      return load4(from);
  };
  V sum[D * D][count] = {};
  for (int f = 0; f < weights.num_facets; ++f) {
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
        double* to = matrix + static_cast<long>(i * tables.num_basis + a) * matrix_stride + j * tables.num_basis + b0 +
                     s * width;
        if constexpr (width == 1)
          *to = sum[i * D + j][s];
        else
          store4(to, sum[i * D + j][s]);
      }
}

/// All rows of A in strips; the last strip overlaps its predecessor, so that no strip is partial.
template <int D, class Lanes>
inline void assemble_own_matrix(const FacetWeights<D>& weights, const VolumeFactors& factors,
                                const ReferenceTablesView& tables, double* matrix, int matrix_stride,
                                const Lanes& lanes) {
  constexpr int wide = D == 3 ? 4 : 8;
  const int num_basis = tables.num_basis;
  const int width = num_basis >= wide ? wide : (num_basis >= 4 ? 4 : 1);
  const int strips = (num_basis + width - 1) / width;
  for (int tile = lanes.first(); tile < num_basis * strips; tile += lanes.count()) {
    const int a = tile / strips, strip = tile % strips;
    const int b0 = strip + 1 < strips ? strip * width : num_basis - width;
    if (width == 8)
      matrix_strip<D, Vector4, 2>(weights, factors, tables, a, b0, matrix, matrix_stride);
    else if (width == 4)
      matrix_strip<D, Vector4, 1>(weights, factors, tables, a, b0, matrix, matrix_stride);
    else
      matrix_strip<D, double, 1>(weights, factors, tables, a, b0, matrix, matrix_stride);
  }
}

/// Identity on the padded diagonal, zeros elsewhere in the padding, in the lower right block and in the slots that a
/// vertical facet of a general patch leaves unused.
template <class Lanes>
inline void clear_padding(const CondensedShape& shape, double* matrix, const Lanes& lanes) {
  const int n = shape.num_unknowns, padded = shape.unknowns_padded, ports_end = padded + shape.num_amplitudes;
  const auto clear = [](double* row, int first, int last) {
    for (int column = first; column < last; ++column) row[column] = 0;
  };
  const bool has_spare_slots = shape.amplitudes_per_port > shape.vertical_amplitudes;
  for (int row = lanes.first(); row < shape.rows; row += lanes.count()) {
    double* entries = matrix + static_cast<long>(row) * shape.stride;
    if (has_spare_slots) clear(entries, row < n ? n : 0, ports_end);
    if (row < n) {
      clear(entries, n, padded);
      clear(entries, ports_end, shape.stride);
    } else {
      const bool amplitude_row = row >= padded && row < ports_end;
      clear(entries, amplitude_row ? n : 0, shape.stride);
      if (row < padded) entries[row] = 1;
    }
  }
}

/// The whole condensed matrix of one element (kernels/condensed_element.hpp). receivers [inclined facet]: the rigid
/// modes of the neighbour's side, or nullptr where it takes none.
/// Flops: 2 n^2 (pairs (1 + vertical facets) + num_curvature_modes + num_rigid) for A, flat in k but for the volume
/// term.
template <int D, class Lanes>
inline void assemble_element(const ElementOperator<D>& op, const ReferenceTablesView& tables,
                             const CondensedShape& shape, const RigidFacet<D>* const* receivers, double* factor_scratch,
                             double* matrix, const Lanes& lanes) {
  FacetWeights<D> weights;
  build_facet_weights<D>(op, tables, weights);
  const VolumeFactors factors = VolumeFactors::at(factor_scratch, tables);
  build_volume_factors<D>(op, tables, factors, lanes);
  clear_padding(shape, matrix, lanes);
  lanes.synchronize();
  assemble_own_matrix<D>(weights, factors, tables, matrix, shape.stride, lanes);
  for (int f = 0; f < op.num_vertical; ++f)
    if (op.vertical[f].port != none) assemble_port<D>(op.vertical[f], tables, shape, matrix, lanes);
  for (int f = 0; f < op.num_inclined; ++f)
    assemble_inclined_port<D>(op, op.inclined[f], receivers[f], tables, shape, matrix, lanes);
  lanes.synchronize();
}

}  // namespace tentpole
