#pragma once

#include "kernels/fracture_facet.hpp"
#include "kernels/patch_workspace.hpp"

namespace tentpole {

/// Intact traction at a point on the own normal of side 0 (tension positive) and its tangential part.
struct PointTraction {
  double normal;
  double tangential;
};

template <int D>
inline PointTraction intact_traction(const FractureWorkspace<D>& workspace, int num_modes, double normal_sign, int q) {
  const double* psi = workspace.psi + static_cast<long>(q) * num_modes;
  const double unit = 1 / sqrt(workspace.link->measure);
  double component[2] = {};
  for (int c = 0; c < D; ++c)
    for (int m = 0; m < num_modes; ++m) component[c] += workspace.intact[c * num_modes + m] * psi[m];
  return {unit * normal_sign * component[0], unit * component[1]};
}

/// Integrates damage and gap up one line under the intact traction of this round and updates its points. `relaxation`:
/// 1, or less to damp; with `freeze` a point whose mode flips keeps the one it had.
template <int D>
inline LineChange integrate_line(const FractureFacet& facet, const FractureLaw& law, const ReferenceTablesView& tables,
                                 const FractureWorkspace<D>& workspace, double normal_sign, int line, double relaxation,
                                 bool freeze) {
  const FractureLine& laid = workspace.lines[line];
  const int per_panel = tables.num_panel_points, num_modes = tables.num_facet_modes;
  const double duration = laid.duration / laid.num_panels;
  const double compliance = 1 / workspace.link->impedance[0][0] + 1 / workspace.link->impedance[1][0];
  LineChange change;
  double q = exp(-law.delay_exponent * facet.damage[line]), gap = facet.gap[line];
  for (int panel = 0; panel < laid.num_panels; ++panel) {
    const int first = laid.first_point + panel * per_panel;
    PointTraction traction[max_panel_points];
    double target[max_panel_points], damage[max_panel_points], opening = 0;
    for (int p = 0; p < per_panel; ++p) {
      traction[p] = intact_traction<D>(workspace, num_modes, normal_sign, first + p);
      const double effective = effective_traction(law, traction[p].normal, traction[p].tangential);
      change.effective = effective > change.effective ? effective : change.effective;
      target[p] = target_damage(law, effective);
    }
    q = integrate_damage_panel(law, duration, per_panel, tables.panel_point, tables.panel_weight, target, q, damage);
    for (int p = 0; p < per_panel; ++p) {
      FracturePoint& point = workspace.points[first + p];
      const double step = damage[p] - point.damage;
      change.damage = fabs(step) > change.damage ? fabs(step) : change.damage;
      point.damage += relaxation * step;
      const ContactMode mode = contact_mode(law, gap, traction[p].normal, traction[p].tangential);
      const double direction = traction[p].tangential < 0 ? -1.0 : 1.0;
      const bool flips =
          static_cast<int>(mode) != point.mode || (mode == ContactMode::slip && direction != point.direction);
      if (flips && point.damage > 0 && !point.is_frozen) {
        ++change.modes;
        point.is_frozen = freeze;
      }
      if (!point.is_frozen) {
        point.mode = static_cast<int>(mode);
        point.direction = direction;
      }
      const TractionMap map =
          traction_map(law, static_cast<ContactMode>(point.mode), point.damage, point.direction, normal_sign);
      opening += tables.panel_weight[p] * compliance * (1 - map.normal) * traction[p].normal;
    }
    gap += duration * opening;
  }
  change.end_damage = -log(q) / law.delay_exponent;
  change.end_gap = gap;
  return change;
}

/// The link of one fracture facet: offsets, impedances, measure. Side s is element facet.element[s].
template <int D>
inline void link_fracture(const PatchBatch& batch, const PatchDescriptor& patch, const PatchWorkspace<D>& workspace,
                          int local) {
  const FractureFacet& facet = batch.fracture_facets[patch.first_fracture + local];
  const FractureWorkspace<D> own = workspace.fracture(local);
  const PatchShape shape = workspace.patch_shape();
  FractureLink& link = *own.link;
  link.num_components = D;
  link.num_modes = workspace.tables.num_facet_modes;
  link.map = own.map;
  link.intact = own.intact;
  for (int side = 0; side < 2; ++side) {
    const int element = facet.element[side] - patch.first_element;
    const ElementOperator<D>& op = *workspace.element(element).op;
    for (int f = 0; f < op.num_vertical; ++f) {
      const VerticalFacet<D>& vertical = op.vertical[f];
      if (vertical.facet != facet.facet[side]) continue;
      link.first[side] = (element * shape.max_ports + vertical.port) * shape.amplitudes_per_port;
      for (int c = 0; c < D; ++c) link.impedance[side][c] = vertical.impedance[c];
      if (side == 0) {
        link.measure = vertical.measure;
        link.normal_sign = vertical.sign;
      }
    }
  }
}

/// Height of the tent pole that a fracture facet contains.
template <int D>
inline double pole_height(const PatchBatch& batch, const FractureFacet& facet) {
  const ElementDescriptor& element = batch.elements[facet.element[0]];
  return element.corner[D + 1][D] - element.corner[element.pole][D];
}

/// Lays out all fracture facets of a patch and starts from the damage on the old front.
template <int D, class Lanes>
inline void prepare_fractures(const PatchBatch& batch, const PatchDescriptor& patch, const PatchWorkspace<D>& workspace,
                              const Lanes& lanes) {
  for (int local = lanes.first(); local < patch.num_fractures; local += lanes.count()) {
    const FractureFacet& facet = batch.fracture_facets[patch.first_fracture + local];
    link_fracture<D>(batch, patch, workspace, local);
    lay_fracture_points<D>(facet, batch.fracture_law, workspace.tables, pole_height<D>(batch, facet),
                           workspace.fracture(local));
  }
  lanes.synchronize();
  for (int local = 0; local < patch.num_fractures; ++local)
    assemble_traction_map<D>(batch.fracture_law, workspace.tables, workspace.fracture(local).link->normal_sign,
                             workspace.fracture(local), lanes);
}

/// Solves the amplitudes at the present maps: incoming = x, and the emitted waves y = t + T x into the product of the
/// coupling scratch.
template <int D, class Lanes>
inline int solve_amplitudes(const PatchWorkspace<D>& workspace, const AmplitudeSystem& system, const Lanes& lanes) {
  const CouplingScratch scratch = CouplingScratch::at(workspace.coupling(), system.size());
  exchange_amplitudes(system, workspace.outgoing(), workspace.incoming(), lanes);
  const int iterations = solve_coupling(system, workspace.incoming(), scratch, lanes);
  respond_all(system, workspace.incoming(), scratch.product, lanes);
  for (int i = lanes.first(); i < system.size(); i += lanes.count())
    scratch.product[i] = workspace.outgoing()[i] - scratch.product[i];
  lanes.synchronize();
  return iterations;
}

/// What one round changed, over all fracture facets.
struct RoundChange {
  double damage = 0;
  int modes = 0;
};

/// One round of damage and contact under the waves of the last solution; rebuilds the maps.
template <int D, class Lanes>
inline RoundChange update_fractures(const PatchBatch& batch, const PatchDescriptor& patch,
                                    const PatchWorkspace<D>& workspace, const double* emitted, double relaxation,
                                    bool freeze, const Lanes& lanes) {
  const ReferenceTablesView& tables = workspace.tables;
  RoundChange change;
  for (int local = 0; local < patch.num_fractures; ++local) {
    const FractureWorkspace<D> own = workspace.fracture(local);
    const FractureFacet& facet = batch.fracture_facets[patch.first_fracture + local];
    const FractureLink& link = *own.link;
    for (int entry = lanes.first(); entry < D * link.num_modes; entry += lanes.count())
      own.intact[entry] = link.intact_amplitude(emitted, entry / link.num_modes, entry % link.num_modes);
    lanes.synchronize();
    for (int line = lanes.first(); line < tables.num_lines; line += lanes.count())
      own.line_changes[line] =
          integrate_line<D>(facet, batch.fracture_law, tables, own, link.normal_sign, line, relaxation, freeze);
    lanes.synchronize();
    for (int line = 0; line < tables.num_lines; ++line) {
      const LineChange& of_line = own.line_changes[line];
      change.damage = of_line.damage > change.damage ? of_line.damage : change.damage;
      change.modes += of_line.modes;
    }
  }
  return change;
}

/// Fills the record of one fracture facet after the last round. Energies from the modes, so that the balance of the
/// patch closes: int s*.(v*_1 - v*_0) = int s*.(Z_0^-1 + Z_1^-1)(s0 - s*) with s* = W s0.
template <int D>
inline void record_fracture(const PatchBatch& batch, const PatchDescriptor& patch, const PatchWorkspace<D>& workspace,
                            int local, int rounds) {
  const ReferenceTablesView& tables = workspace.tables;
  const FractureWorkspace<D> own = workspace.fracture(local);
  const FractureLink& link = *own.link;
  const FractureFacet& facet = batch.fracture_facets[patch.first_fracture + local];
  FractureRecord& record = batch.fracture_records[patch.first_fracture + local];
  record = FractureRecord{};
  record.rounds = rounds;
  for (int line = 0; line < tables.num_lines; ++line) {
    const LineChange& change = own.line_changes[line];
    record.damage[line] = change.end_damage;
    record.gap[line] = change.end_gap;
    record.largest_damage_change = fmax(record.largest_damage_change, change.end_damage - facet.damage[line]);
    record.largest_effective_traction = fmax(record.largest_effective_traction, change.effective);
  }
  const int num_modes = link.num_modes;
  double work = 0;
  for (int c = 0; c < D; ++c)
    for (int m = 0; m < num_modes; ++m) {
      double target = 0;
      for (int other = 0; other < D; ++other)
        for (int n = 0; n < num_modes; ++n)
          target += own.map[((c * D + other) * num_modes + m) * num_modes + n] * own.intact[other * num_modes + n];
      work += target * (1 / link.impedance[0][c] + 1 / link.impedance[1][c]) * (own.intact[c * num_modes + m] - target);
    }
  const int count = num_points(own.lines, tables.num_lines, tables.num_panel_points);
  for (int q = 0; q < count; ++q) {
    const FracturePoint& point = own.points[q];
    ++record.mode_points[point.mode];
    if (D == 1 || point.mode != static_cast<int>(ContactMode::slip)) continue;
    const PointTraction traction = intact_traction<D>(own, num_modes, link.normal_sign, q);
    const double friction = point.damage * batch.fracture_law.friction * fabs(traction.normal);
    const double target = (1 - point.damage) * traction.tangential + friction * point.direction;
    const double slip = (1 / link.impedance[0][D - 1] + 1 / link.impedance[1][D - 1]) * (traction.tangential - target);
    record.friction_work += link.measure * point.weight * friction * point.direction * slip;
  }
  record.fracture_work = work - record.friction_work;
}

/// The damage loop: with damage and contact modes frozen the patch is linear; solve, integrate, repeat until damage
/// changes by less than 1e-10 and no mode flips. Damped where the changes shrink slowly; modes that still flip after 10
/// rounds stay. The last maps are those of the last solution. Returns the iterations of the last solution, -1 where it
/// or the loop did not converge.
template <int D, class Lanes>
inline int solve_fractures(const PatchBatch& batch, const PatchDescriptor& patch, const PatchWorkspace<D>& workspace,
                           const AmplitudeSystem& system, Status& status, const Lanes& lanes) {
  constexpr int max_rounds = 30, settled = 10;
  constexpr double tolerance = 1e-10;
  const double* emitted = CouplingScratch::at(workspace.coupling(), system.size()).product;
  double last_change = 1, relaxation = 1;
  for (int round = 1; round <= max_rounds; ++round) {
    const int iterations = solve_amplitudes(workspace, system, lanes);
    const RoundChange change = update_fractures(batch, patch, workspace, emitted, relaxation, round >= settled, lanes);
    if (change.damage < tolerance && change.modes == 0) {
      for (int local = lanes.first(); local < patch.num_fractures; local += lanes.count())
        record_fracture<D>(batch, patch, workspace, local, round);
      lanes.synchronize();
      return iterations;
    }
    if (round > 2 && change.damage > 0.4 * last_change) relaxation = 0.7;
    last_change = change.damage;
    for (int local = 0; local < patch.num_fractures; ++local)
      assemble_traction_map<D>(batch.fracture_law, workspace.tables, workspace.fracture(local).link->normal_sign,
                               workspace.fracture(local), lanes);
  }
  status = Status::damage_not_converged;
  return -1;
}

}  // namespace tentpole
