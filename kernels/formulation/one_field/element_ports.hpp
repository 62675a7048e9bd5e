#pragma once

#include "kernels/coupling/condensed_element.hpp"
#include "kernels/formulation/one_field/facet_traces.hpp"

namespace tentpole {

/// moment[r][i] += int |N_t| R_r . (phi_a e_i) over one facet with N_t < 0, R_r the rigid modes.
template <int D>
inline void add_rigid_moments(const RigidFacet<D>& facet, const ReferenceTablesView& tables, int a,
                              double (&moment)[RigidFacet<D>::num_rigid][D]) {
  constexpr int d = D + 1;
  const double* value = tables.facet_value(facet.facet) + a * d;
  for (int r = 0; r < RigidFacet<D>::num_rigid; ++r)
    for (int i = 0; i < D; ++i) {
      double sum = 0;
      for (int m = 0; m < d; ++m) sum += facet.modes[r][i][m] * value[m];
      moment[r][i] += facet.root * sum;
    }
}

/// Coefficients of P and O of one interior facet on the reference derivatives:
///   P = sqrt|F| sqrt(2 Z') / (Z + Z') (Z vhat + shat),   O = sqrt|F| / sqrt(2 Z) (Z v - s),
/// so that the incoming amplitude of one side is the outgoing amplitude of the other and O^T A^-1 P is a contraction.
template <int D>
struct PortFactors {
  double incoming[D][D][D + 1];  ///< [c][i][l]
  double outgoing[D][D][D + 1];
};
template <int D>
inline void build_port_factors(const VerticalFacet<D>& facet, PortFactors<D>& factors) {
  for (int c = 0; c < D; ++c) {
    const double inner = facet.impedance[c], outer = facet.outer_impedance[c], root = sqrt(facet.measure);
    const double load = root * sqrt(2 * outer) / (inner + outer), emit = root / sqrt(2 * inner);
    for (int i = 0; i < D; ++i)
      for (int l = 0; l <= D; ++l) {
        factors.incoming[c][i][l] = load * (inner * facet.velocity[c][i][l] + facet.traction[c][i][l]);
        factors.outgoing[c][i][l] = emit * (inner * facet.velocity[c][i][l] - facet.traction[c][i][l]);
      }
  }
}

/// Columns of P and rows of O^T of one interior facet, for the test functions phi_a.
template <int D>
inline void assemble_port(const VerticalFacet<D>& facet, const PortFactors<D>& factors,
                          const ReferenceTablesView& tables, const CondensedShape& shape, int a, double* matrix) {
  constexpr int d = D + 1;
  const int num_basis = tables.num_basis, num_modes = tables.num_facet_modes, facet_stride = tables.facet_stride;
  const double* derivative = tables.facet_derivative(facet.facet);
  const int first = shape.unknowns_padded + facet.port * shape.amplitudes_per_port;
  for (int i = 0; i < D; ++i) {
    const int unknown = i * num_basis + a;
    double *row = matrix + static_cast<long>(unknown) * shape.stride + first,
           *column = matrix + static_cast<long>(first) * shape.stride + unknown;
    for (int c = 0; c < D; ++c)
      for (int m = 0; m < num_modes; m += 4) {
        Vector4 in{}, out{};
        for (int l = 0; l < d; ++l) {
          const Vector4 table = load4(derivative + (l * num_basis + a) * facet_stride + m);
          in += factors.incoming[c][i][l] * table;
          out += factors.outgoing[c][i][l] * table;
        }
        store_modes(in, num_modes, m, row + c * num_modes);
        store_modes(out, num_modes, m, column + c * num_modes * static_cast<long>(shape.stride), shape.stride);
      }
  }
}

/// Columns of P and rows of O^T of one inclined facet, for the test functions phi_a. Slots of a port: waves [c][m],
/// then rigid modes; those that do not come in (go out) stay zero. P = wave_c(what) and the rigid moments, O = the
/// waves and the moments of the displacement with the rigid modes of the side that receives them.
template <int D>
inline void assemble_inclined_port(const ElementOperator<D>& op, const InclinedFacet<D>& facet,
                                   const ReferenceTablesView& tables, const CondensedShape& shape, int a,
                                   double* matrix) {
  constexpr int d = D + 1;
  const int num_basis = tables.num_basis, num_modes = tables.num_facet_modes, stride = tables.facet_stride;
  const double *derivative = tables.facet_derivative(facet.facet), *value = tables.facet_value(facet.facet);
  const RigidFacet<D>* receiver = facet.receiver;
  const int first = shape.unknowns_padded + facet.port * shape.amplitudes_per_port;
  const auto row_of = [&](int slot) { return matrix + static_cast<long>(first + slot) * shape.stride; };
  double moment[RigidFacet<D>::num_rigid][D] = {};
  for (int f = 0; f < op.num_rigid_facets && facet.rigid != none; ++f)
    add_rigid_moments<D>(op.rigid[f], tables, a, moment);
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
      column[slot] = moment[rigid][i];
      double out = 0;
      for (int m = 0; receiver && m < d; ++m) out += receiver->modes[rigid][i][m] * value[a * d + m];
      row_of(slot)[unknown] = receiver ? receiver->root * out : 0.0;
    }
  }
}

}  // namespace tentpole
