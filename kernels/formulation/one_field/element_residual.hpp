#pragma once

#include "kernels/formulation/one_field/facet_residual.hpp"

namespace tentpole {

/// residual = b + P x - A c of the elements of a range, matrix-free from the weak form, into `right`; with a solution
/// the balance of each facet too. Without one (`system` is nullptr) it is the right-hand side b, to which facets inside
/// the patch add nothing. In three steps, between which the lanes meet: what depends on the element alone, fluxes of
/// four modes at a time, and one row for each test function. gradients hold those of the solution (solution_gradients).

inline const double* body_force_block(const PatchBatch& batch, const ElementDescriptor& element) {
  return element.body_force_data == none ? nullptr : batch.prescribed + element.body_force_data;
}

/// Gradient modes of the solution on all facets of the elements of a range.
template <int D, class Lanes>
TENTPOLE_STEP void solution_gradients(const PatchBatch& batch, const PatchWorkspace<D>& workspace, ElementRange range,
                                      const Lanes& lanes) {
  constexpr int num_facets = D + 2;
  const ReferenceTablesView& tables = workspace.tables;
  share(lanes, range.count * num_facets, D * (D + 1) * num_mode_blocks(tables), [&](int index) {
    const int e = range.first + index / num_facets, facet = index % num_facets;
    const ElementWorkspace<D> own = workspace.element(e);
    const int code = facet_table(batch.elements[workspace.patch.first_element + e], D, facet);
    return [&tables, derivative = tables.facet_derivative(code), solution = own.solution(),
            gradient = own.gradient(facet)](int block) {
      gradient_block<D>(tables, derivative, solution, gradient, block);
    };
  });
  lanes.synchronize();
}

/// Mode q of rho b - (rho v_t - div sigma), times |det J|.
template <int D>
inline void volume_residual(const PatchWorkspace<D>& workspace, const ElementWorkspace<D>& own,
                            const double* body_force, bool has_solution, int q) {
  constexpr int d = D + 1;
  const ReferenceTablesView& tables = workspace.tables;
  const ElementOperator<D>& op = own.op();
  const int num_basis = tables.num_basis, num_modes = tables.num_volume_modes;
  if (!body_force && !has_solution) return;
  for (int i = 0; i < D; ++i)
    own.curvature()[i * num_modes + q] = body_force ? op.determinant * body_force[i * num_modes + q] : 0;
  if (!has_solution || q >= tables.num_curvature_modes) return;
  for (int l = 0, pair = 0; l < d; ++l)
    for (int k = l; k < d; ++k, ++pair) {
      const double* table =
          tables.curvature + (static_cast<long>(pair) * tables.num_curvature_modes + q) * tables.basis_stride;
      for (int j = 0; j < D; ++j) {
        const double second = op.determinant * dot(table, own.solution() + j * num_basis, num_basis);
        for (int i = 0; i < D; ++i) own.curvature()[i * num_modes + q] -= volume_weight<D>(op, i, j, l, k) * second;
      }
    }
}

/// |N_t| sum_r amount_r R_r on one facet with N_t < 0 in chi modes, amount_r = int R_r . (u_ext - u) |N_t| over all
/// such facets: what comes from below or, as amplitudes, through inclined facets, minus the own rigid motion.
template <int D>
inline void rigid_motion(const PatchWorkspace<D>& workspace, const ElementWorkspace<D>& own, const double* incoming,
                         int facet) {
  constexpr int d = D + 1, num_fields = D + num_symmetric(D), num_rigid = ElementOperator<D>::num_rigid;
  const ElementOperator<D>& op = own.op();
  const int num_modes = workspace.tables.num_facet_modes, per_port = workspace.patch_shape().amplitudes_per_port;
  double amount[num_rigid] = {};
  for (int f = 0; f < op.num_rigid_facets && incoming; ++f)
    for (int r = 0; r < num_rigid; ++r) amount[r] -= rigid_amount<D>(op.rigid[f], r, own.displacement(f));
  for (int f = 0; f < op.num_inflow; ++f)
    for (int r = 0; r < num_rigid; ++r)
      amount[r] +=
          rigid_amount<D>(op.rigid[f], r, own.inflow_data() + f * workspace.inflow_block() + num_fields * num_modes);
  for (int f = 0; f < op.num_inclined && incoming; ++f)
    if (op.inclined[f].rigid != none) {
      const double* slots = incoming + op.inclined[f].port * per_port + op.inclined[f].num_waves * num_modes;
      for (int r = 0; r < num_rigid; ++r) amount[r] += slots[r];
    }
  const RigidFacet<D>& rigid = op.rigid[facet];
  double motion[D * d] = {};
  for (int r = 0; r < num_rigid; ++r)
    for (int i = 0; i < D; ++i)
      for (int m = 0; m < d; ++m) motion[i * d + m] += rigid.root * amount[r] * rigid.modes[r][i][m];
  for (int entry = 0; entry < D * d; ++entry) own.motion(facet)[entry] = motion[entry];
}

/// Four modes of the flux through one facet; f counts inflow, vertical and inclined facets.
template <int D>
inline void flux_through_facet(const PatchBatch& batch, const PatchWorkspace<D>& workspace,
                               const ElementWorkspace<D>& own, const double* incoming, int f, int m) {
  const ElementOperator<D>& op = own.op();
  const int per_port = workspace.patch_shape().amplitudes_per_port, vertical = f - op.num_inflow,
            inclined = vertical - op.num_vertical;
  if (vertical < 0) {
    inflow_residual<D>(workspace, own, op.inflow[f], own.inflow_data() + f * workspace.inflow_block(),
                       incoming != nullptr, m);
  } else if (inclined < 0) {
    const VerticalFacet<D>& facet = op.vertical[vertical];
    const bool is_interior = facet.port != none;
    if (is_interior && !incoming) return;
    const double* amplitudes = is_interior ? incoming + facet.port * per_port : nullptr;
    vertical_residual<D>(workspace, own, facet, VerticalSource{amplitudes, batch.prescribed, incoming != nullptr}, m);
  } else if (inclined < op.num_inclined && incoming) {
    inclined_residual<D>(workspace, own, op.inclined[inclined], incoming + op.inclined[inclined].port * per_port, m);
  }
}

/// What the rows of the residual of one element are made of.
template <int D>
struct ResidualTerms {
  int num_volume_modes;             ///< of the volume term; 0 where it vanishes
  int num_facets;                   ///< facets with a flux
  const double* derivative[D + 2];  ///< [facet]: table
  const double* flux[D + 2];        ///< [facet]
  int num_rigid;                    ///< facets with rigid motions
  const double* value[D + 2];       ///< [rigid facet]: table
  const double* motion;             ///< [rigid facet][i][m]

  void add(const ReferenceTablesView& tables, const ElementWorkspace<D>& own, int facet) {
    derivative[num_facets] = tables.facet_derivative(facet);
    flux[num_facets++] = own.flux(facet);
  }
};
template <int D>
inline ResidualTerms<D> residual_terms(const PatchWorkspace<D>& workspace, const ElementWorkspace<D>& own,
                                       bool has_body_force, bool has_solution) {
  const ReferenceTablesView& tables = workspace.tables;
  const ElementOperator<D>& op = own.op();
  ResidualTerms<D> terms;
  terms.num_volume_modes = has_body_force ? tables.num_volume_modes : (has_solution ? tables.num_curvature_modes : 0);
  terms.num_facets = 0;
  for (int f = 0; f < op.num_inflow; ++f) terms.add(tables, own, op.inflow[f].facet);
  for (int f = 0; f < op.num_inclined && has_solution; ++f) terms.add(tables, own, op.inclined[f].facet);
  for (int f = 0; f < op.num_vertical; ++f)
    if (has_solution || op.vertical[f].port == none) terms.add(tables, own, op.vertical[f].facet);
  terms.num_rigid = op.num_rigid_facets;
  for (int f = 0; f < op.num_rigid_facets; ++f) terms.value[f] = tables.facet_value(op.rigid[f].facet);
  terms.motion = own.motion(0);
  return terms;
}

/// Row a of the residual: all terms tested with phi_a.
template <int D>
inline void test_residual(const ReferenceTablesView& tables, const ElementWorkspace<D>& own,
                          const ResidualTerms<D>& terms, int a) {
  constexpr int d = D + 1;
  const int num_basis = tables.num_basis, num_modes = tables.num_volume_modes;
  Vector4 sum[D] = {};
  for (int f = 0; f < terms.num_facets; ++f) test_facet<D>(tables, terms.derivative[f], terms.flux[f], a, sum);
  double residual[D];
  for (int i = 0; i < D; ++i) residual[i] = (sum[i][0] + sum[i][1]) + (sum[i][2] + sum[i][3]);
  for (int l = 0; l < d && terms.num_volume_modes > 0; ++l) {
    const double* table = tables.volume_derivative + static_cast<long>(l * num_basis + a) * num_modes;
    for (int i = 0; i < D; ++i)
      residual[i] += own.op().time_slope(l) * dot(table, own.curvature() + i * num_modes, terms.num_volume_modes);
  }
  for (int r = 0; r < terms.num_rigid; ++r)
    for (int i = 0; i < D; ++i)
      for (int m = 0; m < d; ++m) residual[i] += terms.motion[(r * D + i) * d + m] * terms.value[r][a * d + m];
  for (int i = 0; i < D; ++i) own.right()[i * num_basis + a] = residual[i];
}

/// Balance of facet f, counted as in flux_through_facet.
template <int D>
inline void balance_facet(const PatchWorkspace<D>& workspace, const ElementWorkspace<D>& own, int f) {
  const ElementOperator<D>& op = own.op();
  const int vertical = f - op.num_inflow, inclined = vertical - op.num_vertical;
  if (vertical < 0) {
    own.balance()[f] = inflow_balance<D>(workspace, own, op.inflow[f]);
  } else if (inclined < 0) {
    own.balance()[f] = vertical_balance<D>(workspace, own, op.vertical[vertical]);
  } else if (inclined < op.num_inclined) {
    own.balance()[f] = inclined_balance<D>(workspace, own, op.inclined[inclined]);
  }
}

template <int D, class Lanes>
TENTPOLE_STEP void element_residuals(const PatchBatch& batch, const PatchWorkspace<D>& workspace, ElementRange range,
                                     const AmplitudeSystem* system, const Lanes& lanes) {
  constexpr int d = D + 1, num_facets = D + 2;
  const ReferenceTablesView& tables = workspace.tables;
  const bool has_solution = system != nullptr;
  const auto body_force = [&](int e) {
    return body_force_block(batch, batch.elements[workspace.patch.first_element + e]);
  };
  const auto incoming = [&](int e) -> const double* {
    return has_solution ? workspace.incoming() + system->offset(e) : nullptr;
  };
  share(lanes, range.count, tables.num_volume_modes, [&](int e) {
    return [&workspace, own = workspace.element(range.first + e), force = body_force(range.first + e),
            has_solution](int q) { volume_residual<D>(workspace, own, force, has_solution, q); };
  });
  if (has_solution)
    share(lanes, range.count, num_facets * D * d, [&](int e) {
      return [&tables, own = workspace.element(range.first + e)](int item) {
        const int f = item / (D * d);
        if (f < own.op().num_rigid_facets)
          own.displacement(f)[item % (D * d)] =
              displacement_mode<D>(tables, own.op().rigid[f].facet, own.solution(), item % (D * d));
      };
    });
  lanes.synchronize();
  share(lanes, range.count, num_facets * num_mode_blocks(tables), [&](int e) {
    return [&batch, &workspace, own = workspace.element(range.first + e), waves = incoming(range.first + e)](int item) {
      flux_through_facet<D>(batch, workspace, own, waves, item % num_facets, 4 * (item / num_facets));
    };
  });
  share(lanes, range.count, num_facets, [&](int e) {
    return [&workspace, own = workspace.element(range.first + e), waves = incoming(range.first + e)](int f) {
      if (f < own.op().num_rigid_facets) rigid_motion<D>(workspace, own, waves, f);
    };
  });
  lanes.synchronize();
  share(lanes, range.count, tables.num_basis, [&](int e) {
    const ElementWorkspace<D> own = workspace.element(range.first + e);
    const ResidualTerms<D> terms =
        residual_terms<D>(workspace, own, body_force(range.first + e) != nullptr, has_solution);
    return [&tables, own, terms](int a) { test_residual<D>(tables, own, terms, a); };
  });
  share(lanes, range.count, workspace.largest_shape().unknowns_padded - tables.num_unknowns, [&](int e) {
    double* padding = workspace.element(range.first + e).right() + tables.num_unknowns;
    return [padding](int row) { padding[row] = 0; };
  });
  if (has_solution)
    share(lanes, range.count, num_facets, [&](int e) {
      return [&workspace, own = workspace.element(range.first + e)](int f) { balance_facet<D>(workspace, own, f); };
    });
  lanes.synchronize();
}

}  // namespace tentpole
