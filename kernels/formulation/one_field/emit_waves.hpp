#pragma once

#include "kernels/formulation/one_field/element_residual.hpp"

namespace tentpole {

/// Outgoing amplitudes O^T c through one vertical facet, four modes, from the gradient modes of the solution.
template <int D>
inline void emit_through_vertical(const ReferenceTablesView& tables, const VerticalFacet<D>& facet,
                                  const double* gradient, double* slots, int m) {
  constexpr int d = D + 1;
  const int stride = tables.facet_stride, num_modes = tables.num_facet_modes;
  for (int c = 0; c < D; ++c) {
    Vector4 wave{};
    for (int i = 0; i < D; ++i)
      for (int l = 0; l < d; ++l)
        wave += (facet.impedance[c] * facet.velocity[c][i][l] - facet.traction[c][i][l]) *
                load4(gradient + (i * d + l) * stride + m);
    wave *= sqrt(facet.measure / (2 * facet.impedance[c]));
    store_modes(wave, num_modes, m, slots + c * num_modes);
  }
}

/// Outgoing waves through one inclined facet, four modes.
template <int D>
inline void emit_through_inclined(const ReferenceTablesView& tables, const InclinedFacet<D>& facet,
                                  const double* gradient, double* slots, int m) {
  constexpr int d = D + 1;
  const int stride = tables.facet_stride, num_modes = tables.num_facet_modes;
  for (int c = 0; c < facet.num_waves; ++c) {
    Vector4 wave{};
    for (int i = 0; i < D; ++i)
      for (int l = 0; l < d; ++l) wave += facet.outgoing[c][i][l] * load4(gradient + (i * d + l) * stride + m);
    store_modes(wave, num_modes, m, slots + c * num_modes);
  }
}

/// The moments of the displacement that the other side of an inclined facet takes.
template <int D>
inline void emit_rigid_moments(const ReferenceTablesView& tables, const InclinedFacet<D>& facet,
                               const double* coefficients, double* slots) {
  constexpr int d = D + 1, num_rigid = RigidFacet<D>::num_rigid;
  double displacement[D * d];
  for (int entry = 0; entry < D * d; ++entry)
    displacement[entry] = displacement_mode<D>(tables, facet.facet, coefficients, entry);
  for (int r = 0; r < num_rigid; ++r)
    slots[facet.num_waves * tables.num_facet_modes + r] =
        facet.receiver ? rigid_amount<D>(*facet.receiver, r, displacement) : 0.0;
}

/// Part of what element e emits through its ports: four modes of each port, or (block = num_mode_blocks) the moments.
template <int D>
inline void emit_waves(const PatchWorkspace<D>& workspace, const ElementWorkspace<D>& own, double* outgoing,
                       int block) {
  const ReferenceTablesView& tables = workspace.tables;
  const ElementOperator<D>& op = own.op();
  const int per_port = workspace.patch_shape().amplitudes_per_port;
  if (block == num_mode_blocks(tables)) {
    for (int f = 0; f < op.num_inclined; ++f)
      emit_rigid_moments<D>(tables, op.inclined[f], own.solution(), outgoing + op.inclined[f].port * per_port);
    return;
  }
  for (int f = 0; f < op.num_vertical; ++f)
    if (op.vertical[f].port != none)
      emit_through_vertical<D>(tables, op.vertical[f], own.gradient(op.vertical[f].facet),
                               outgoing + op.vertical[f].port * per_port, 4 * block);
  for (int f = 0; f < op.num_inclined; ++f)
    emit_through_inclined<D>(tables, op.inclined[f], own.gradient(op.inclined[f].facet),
                             outgoing + op.inclined[f].port * per_port, 4 * block);
}

/// The waves that the elements of a patch emit with their solutions, into the outgoing amplitudes; keeps their
/// gradients.
template <int D, class Lanes>
TENTPOLE_STEP void emit_solutions(const PatchBatch& batch, const PatchWorkspace<D>& workspace,
                                  const AmplitudeSystem& system, const Lanes& lanes) {
  for_each_range(lanes, workspace.patch.num_elements, [&](ElementRange range) {
    solution_gradients<D>(batch, workspace, range, lanes);
    share(lanes, range.count, num_mode_blocks(workspace.tables) + 1, [&](int e) {
      double* outgoing = workspace.outgoing() + system.offset(range.first + e);
      return [=, &workspace, own = workspace.element(range.first + e)](int block) {
        emit_waves<D>(workspace, own, outgoing, block);
      };
    });
  });
  lanes.synchronize();
}

}  // namespace tentpole
