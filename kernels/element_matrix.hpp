#pragma once

#include "kernels/condensed_element.hpp"
#include "kernels/element_operator.hpp"
#include "kernels/lanes.hpp"
#include "kernels/simd.hpp"

namespace tentpole {

/// Contraction weights of all facet terms of one element: facet f contributes weight[f][l, l'][i, j] <d_l phi_a d_l'
/// phi_b>.
template <int D>
struct FacetWeights {
  static constexpr int pairs = (D + 1) * (D + 1);
  int num_facets;
  const double* gram[D + 2];  ///< table of each facet, [a][l, l'][b]
  double weight[D + 2][pairs][D * D];
};

/// -int what^T A_N w over an inflow facet, with A_N = N_t diag(rho, C^-1) - [0 N_x; N_x^T 0]:
/// (-N_t) (rho v.v + E:C:E) + vhat.(sigma N_x) + (sigmahat N_x).v.
template <int D>
inline void inflow_weights(const ElementOperator<D>& op, const FrontFacet<D>& facet,
                           double (&weight)[(D + 1) * (D + 1)][D * D]) {
  const double* normal = facet.covector;
  const double minus_time = -normal[D];
  for (int l = 0; l <= D; ++l)
    for (int k = 0; k <= D; ++k) {
      const double *g = op.inverse_jacobian[l], *h = op.inverse_jacobian[k];
      double g_h = 0, g_normal = 0, h_normal = 0;
      for (int i = 0; i < D; ++i) g_h += g[i] * h[i], g_normal += g[i] * normal[i], h_normal += h[i] * normal[i];
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
          double value = minus_time * (op.lambda * g[i] * h[j] + op.mu * g[j] * h[i]) +
                         g[D] * (op.lambda * normal[i] * h[j] + op.mu * normal[j] * h[i]) +
                         h[D] * (op.lambda * normal[j] * g[i] + op.mu * normal[i] * g[j]);
          if (i == j)
            value +=
                minus_time * (op.density * g[D] * h[D] + op.mu * g_h) + op.mu * (g[D] * h_normal + h[D] * g_normal);
          weight[l * (D + 1) + k][i * D + j] = value;
        }
    }
}

/// Test and own trial factors of one component of a vertical facet: the residual term is
///   |F| < (Z vhat + shat)/Z (s - s*) >,  s - s* = trial(own) - data.
/// Interior: s - s* = Z/(Z + Z') [(s + Z' v) - incoming]; boundary: velocity Z v - Z vbar, traction s - sbar, absorbing
/// half the sum.
template <int D>
inline void facet_factors(const VerticalFacet<D>& facet, int c, double& test_velocity, double& test_traction,
                          double& trial_velocity, double& trial_traction) {
  const double impedance = facet.impedance[c];
  test_velocity = facet.measure;
  test_traction = facet.measure / impedance;
  if (facet.port != none) {
    const double outer = facet.outer_impedance[c], share = impedance / (impedance + outer);
    trial_velocity = share * outer;
    trial_traction = share;
  } else if (facet.kind[c] == BoundaryKind::velocity) {
    trial_velocity = impedance;
    trial_traction = 0;
  } else if (facet.kind[c] == BoundaryKind::traction) {
    trial_velocity = 0;
    trial_traction = 1;
  } else {
    trial_velocity = 0.5 * impedance;
    trial_traction = 0.5;
  }
}

template <int D>
inline void vertical_weights(const VerticalFacet<D>& facet, double (&weight)[(D + 1) * (D + 1)][D * D]) {
  constexpr int d = D + 1;
  double test[D][D][d], trial[D][D][d];
  for (int c = 0; c < D; ++c) {
    double test_velocity, test_traction, trial_velocity, trial_traction;
    facet_factors<D>(facet, c, test_velocity, test_traction, trial_velocity, trial_traction);
    for (int i = 0; i < D; ++i)
      for (int l = 0; l < d; ++l) {
        test[c][i][l] = test_velocity * facet.velocity[c][i][l] + test_traction * facet.traction[c][i][l];
        trial[c][i][l] = trial_velocity * facet.velocity[c][i][l] + trial_traction * facet.traction[c][i][l];
      }
  }
  for (int l = 0; l < d; ++l)
    for (int k = 0; k < d; ++k)
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
          double sum = 0;
          for (int c = 0; c < D; ++c) sum += test[c][i][l] * trial[c][j][k];
          weight[l * d + k][i * D + j] = sum;
        }
}

/// -int what^T A_N^- w of an inclined facet: the sum over incoming waves of wave(what) wave(w).
template <int D>
inline void inclined_weights(const InclinedFacet<D>& facet, double (&weight)[(D + 1) * (D + 1)][D * D]) {
  constexpr int d = D + 1;
  for (int l = 0; l < d; ++l)
    for (int k = 0; k < d; ++k)
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
          double sum = 0;
          for (int c = 0; c < facet.num_waves; ++c) sum += facet.incoming[c][i][l] * facet.incoming[c][j][k];
          weight[l * d + k][i * D + j] = sum;
        }
}

template <int D>
inline void build_facet_weights(const ElementOperator<D>& op, const ReferenceTablesView& tables,
                                FacetWeights<D>& weights) {
  int count = 0;
  for (int f = 0; f < op.num_inflow; ++f, ++count) {
    weights.gram[count] = tables.facet_gram(op.inflow[f].facet);
    inflow_weights<D>(op, op.inflow[f], weights.weight[count]);
  }
  for (int f = 0; f < op.num_vertical; ++f, ++count) {
    weights.gram[count] = tables.facet_gram(op.vertical[f].facet);
    vertical_weights<D>(op.vertical[f], weights.weight[count]);
  }
  for (int f = 0; f < op.num_inclined; ++f, ++count) {
    weights.gram[count] = tables.facet_gram(op.inclined[f].facet);
    inclined_weights<D>(op.inclined[f], weights.weight[count]);
  }
  weights.num_facets = count;
}

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

/// sum over the facets with N_t < 0 of int |N_t| R_r . (phi_a e_i), R_r the rigid mode.
template <int D>
inline double rigid_moment(const ElementOperator<D>& op, const ReferenceTablesView& tables, int rigid, int i, int a) {
  constexpr int d = D + 1;
  double moment = 0;
  for (int f = 0; f < op.num_rigid_facets; ++f) {
    const double* value = tables.facet_value(op.rigid[f].facet) + a * d;
    double sum = 0;
    for (int m = 0; m < d; ++m) sum += op.rigid[f].modes[rigid][i][m] * value[m];
    moment += op.rigid[f].root * sum;
  }
  return moment;
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

/// Columns of P and rows of O^T of one interior facet:
///   P = sqrt|F| sqrt(2 Z') / (Z + Z') (Z vhat + shat),   O = sqrt|F| / sqrt(2 Z) (Z v - s),
/// so that the incoming amplitude of one side is the outgoing amplitude of the other and O^T A^-1 P is a contraction.
template <int D, class Lanes>
inline void assemble_port(const VerticalFacet<D>& facet, const ReferenceTablesView& tables, const CondensedShape& shape,
                          double* matrix, const Lanes& lanes) {
  constexpr int d = D + 1;
  const int num_basis = tables.num_basis, num_modes = tables.num_facet_modes, facet_stride = tables.facet_stride;
  const double* derivative = tables.facet_derivative(facet.facet);
  const int first = shape.unknowns_padded + facet.port * shape.amplitudes_per_port;
  double incoming[D][D][d], outgoing[D][D][d];
  for (int c = 0; c < D; ++c) {
    const double inner = facet.impedance[c], outer = facet.outer_impedance[c], root = sqrt(facet.measure);
    const double load = root * sqrt(2 * outer) / (inner + outer), emit = root / sqrt(2 * inner);
    for (int i = 0; i < D; ++i)
      for (int l = 0; l < d; ++l) {
        incoming[c][i][l] = load * (inner * facet.velocity[c][i][l] + facet.traction[c][i][l]);
        outgoing[c][i][l] = emit * (inner * facet.velocity[c][i][l] - facet.traction[c][i][l]);
      }
  }
  for (int a = lanes.first(); a < num_basis; a += lanes.count())
    for (int i = 0; i < D; ++i) {
      const int unknown = i * num_basis + a;
      double* row = matrix + static_cast<long>(unknown) * shape.stride + first;
      for (int c = 0; c < D; ++c)
        for (int m = 0; m < num_modes; m += 4) {
          Vector4 in{}, out{};
          for (int l = 0; l < d; ++l) {
            const Vector4 table = load4(derivative + (l * num_basis + a) * facet_stride + m);
            in += incoming[c][i][l] * table;
            out += outgoing[c][i][l] * table;
          }
          const int count = num_modes - m < 4 ? num_modes - m : 4;
          for (int s = 0; s < count; ++s) {
            row[c * num_modes + m + s] = in[s];
            matrix[static_cast<long>(first + c * num_modes + m + s) * shape.stride + unknown] = out[s];
          }
        }
    }
}

/// Columns of P and rows of O^T of one inclined facet. Slots of a port: waves [c][m], then rigid modes; those that do
/// not come in (go out) stay zero. P = wave_c(what) and the rigid moments, O = the waves and the moments of the
/// displacement with the rigid modes of the side that receives them (`receiver`, its side of the facet).
template <int D, class Lanes>
inline void assemble_inclined_port(const ElementOperator<D>& op, const InclinedFacet<D>& facet,
                                   const RigidFacet<D>* receiver, const ReferenceTablesView& tables,
                                   const CondensedShape& shape, double* matrix, const Lanes& lanes) {
  constexpr int d = D + 1;
  const int num_basis = tables.num_basis, num_modes = tables.num_facet_modes, stride = tables.facet_stride;
  const double *derivative = tables.facet_derivative(facet.facet), *value = tables.facet_value(facet.facet);
  const int first = shape.unknowns_padded + facet.port * shape.amplitudes_per_port;
  const auto row_of = [&](int slot) { return matrix + static_cast<long>(first + slot) * shape.stride; };
  for (int a = lanes.first(); a < num_basis; a += lanes.count())
    for (int i = 0; i < D; ++i) {
      const int unknown = i * num_basis + a;
      double* column = matrix + static_cast<long>(unknown) * shape.stride + first;
      for (int c = 0; c < facet.num_waves; ++c)
        for (int m = 0; m < num_modes; ++m) {
          double in = 0, out = 0;
          for (int l = 0; l < d; ++l) {
            const double table = derivative[(l * num_basis + a) * stride + m];
            in += facet.incoming[c][i][l] * table;
            out += facet.outgoing[c][i][l] * table;
          }
          column[c * num_modes + m] = in;
          row_of(c * num_modes + m)[unknown] = out;
        }
      for (int rigid = 0; rigid < op.num_rigid; ++rigid) {
        const int slot = facet.num_waves * num_modes + rigid;
        column[slot] = facet.rigid == none ? 0.0 : rigid_moment<D>(op, tables, rigid, i, a);
        double out = 0;
        for (int m = 0; receiver && m < d; ++m) out += receiver->modes[rigid][i][m] * value[a * d + m];
        row_of(slot)[unknown] = receiver ? receiver->root * out : 0.0;
      }
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
