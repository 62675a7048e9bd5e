#pragma once

#include "kernels/condensed_element.hpp"
#include "kernels/element_operator.hpp"
#include "kernels/lanes.hpp"
#include "kernels/simd.hpp"

namespace tentpole {

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

}  // namespace tentpole
