#pragma once

#include "kernels/element/larger_or_nan.hpp"
#include "kernels/fracture/fracture_facet.hpp"
#include "kernels/patch/patch_workspace.hpp"

namespace tentpole {

/// Largest component of (next M - M) s0, the traction in the frame.
inline double target_change(const TractionMap& map, const TractionMap& next, const PointTraction& traction) {
  const double normal = (next.normal - map.normal) * traction.normal;
  const double tangential =
      (next.tangential - map.tangential) * traction.tangential + (next.friction - map.friction) * traction.normal;
  return larger_or_nan(fabs(normal), fabs(tangential));
}

/// Integrates damage and gap up one line under the tractions of the last solution: next_damage and next_contact of its
/// points and what the line reports. The gap, int (v*_1 - v*_0).n >= 0, is that of the last solution; a point's mode
/// depends on the gap below it alone, so no point contradicts itself.
template <int D>
inline void integrate_line(const FractureFacet& facet, const FractureLaw& law, const ReferenceTablesView& tables,
                           const FractureWorkspace<D>& workspace, int line_index) {
  FractureLine& line = workspace.lines[line_index];
  const FractureLink& link = *workspace.link;
  const int per_panel = tables.num_panel_points;
  const double duration = line.duration / line.num_panels;
  double q = exp(-law.delay_exponent * facet.damage[line_index]), gap = facet.gap[line_index];
  line.damage_change = line.traction_change = line.secant_product = line.secant_square = line.largest_normal = 0;
  for (int point = 0; point < line.num_panels * per_panel; ++point)
    line.largest_normal =
        larger_or_nan(line.largest_normal, fabs(traction_at<D>(workspace, line.first_point + point).normal));
  const ContactTolerance tolerance = contact_tolerance(line.largest_normal, link.compliance(0), line.duration);
  for (int panel = 0; panel < line.num_panels; ++panel) {
    const int first = line.first_point + panel * per_panel;
    double target[max_panel_points], damage[max_panel_points];
    for (int p = 0; p < per_panel; ++p) {
      const PointTraction traction = traction_at<D>(workspace, first + p);
      target[p] = target_damage(law, effective_traction(law, link.normal_sign * traction.normal, traction.tangential));
    }
    q = integrate_damage_panel(law, duration, {per_panel, tables.panel_point, tables.panel_weight}, target, q, damage);
    for (int p = 0; p < per_panel; ++p) {
      FracturePoint& point = workspace.points[first + p];
      const PointTraction traction = traction_at<D>(workspace, first + p);
      const double normal = link.normal_sign * traction.normal;
      point.next_damage = damage[p];
      point.next_contact =
          point.is_frozen ? point.contact : contact_state(law, tolerance, gap, normal, traction.tangential);
      const TractionMap map = traction_map(law, point.contact, point.damage, link.normal_sign),
                        next = traction_map(law, point.next_contact, point.next_damage, link.normal_sign);
      const double step = point.next_damage - point.damage, difference = step - point.previous_step;
      line.secant_product += point.weight * difference * step;
      line.secant_square += point.weight * difference * difference;
      line.damage_change = larger_or_nan(line.damage_change, fabs(step));
      line.traction_change = larger_or_nan(line.traction_change, target_change(map, next, traction));
      gap += duration * tables.panel_weight[p] * link.compliance(0) * (1 - map.normal) * normal;
    }
    gap = fmax(gap, 0.0);
  }
  line.end_damage = -log(q) / law.delay_exponent;
  line.end_gap = gap;
}

/// The link of one fracture facet: offsets, impedances, measure. Side s is element facet.element[s].
template <int D>
inline void link_fracture(const PatchBatch& batch, const PatchWorkspace<D>& workspace, const AmplitudeSystem& system,
                          int local) {
  const PatchDescriptor& patch = workspace.patch;
  const FractureFacet& facet = batch.fracture_facets[patch.first_fracture + local];
  const FractureWorkspace<D> own = workspace.fracture(local);
  FractureLink& link = *own.link;
  link.num_components = D;
  link.num_modes = workspace.tables.num_facet_modes;
  link.map = own.map;
  link.intact = own.intact;
  for (int side = 0; side < 2; ++side) {
    const int element = facet.element[side] - patch.first_element;
    const ElementOperator<D>& op = workspace.element(element).op();
    for (int f = 0; f < op.num_vertical; ++f) {
      const VerticalFacet<D>& vertical = op.vertical[f];
      if (vertical.facet != facet.facet[side]) continue;
      link.first[side] = system.offset(element) + vertical.port * system.amplitudes_per_port;
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

/// Calls work(facet, point) for the points of all fracture facets of a patch. The lanes do not meet.
template <int D, class Lanes, class Work>
inline void share_points(const PatchWorkspace<D>& workspace, const Lanes& lanes, Work work) {
  const int max_points = static_cast<int>(FractureWorkspace<D>::max_points(workspace.tables));
  share(lanes, workspace.patch.num_fractures, max_points, [&](int local) {
    const FractureWorkspace<D> own = workspace.fracture(local);
    return [=, &work, num_points = own.num_points(workspace.tables)](int q) {
      if (q < num_points) work(own, q);
    };
  });
}

/// W of all fracture facets of a patch.
template <int D, class Lanes>
inline void assemble_traction_maps(const FractureLaw& law, const PatchWorkspace<D>& workspace, const Lanes& lanes) {
  const int num_modes = workspace.tables.num_facet_modes;
  share_points<D>(workspace, lanes, [&](const FractureWorkspace<D>& own, int q) { load_point_loss<D>(law, own, q); });
  lanes.synchronize();
  share(lanes, workspace.patch.num_fractures, num_modes * num_modes, [&](int local) {
    return [=, &workspace, own = workspace.fracture(local)](int pair) {
      const int m = pair / num_modes, n = pair % num_modes;
      if (n <= m) assemble_map_entries<D>(workspace.tables, own, m, n);
    };
  });
  lanes.synchronize();
}

/// s0 at all points of all fracture facets from the waves `outgoing`.
template <int D, class Lanes>
inline void load_tractions(const PatchWorkspace<D>& workspace, const double* outgoing, const Lanes& lanes) {
  load_intact_tractions(workspace.links(), workspace.patch.num_fractures, outgoing, lanes);
  share_points<D>(workspace, lanes,
                  [&](const FractureWorkspace<D>& own, int q) { evaluate_traction<D>(workspace.tables, own, q); });
  lanes.synchronize();
}

/// Lays out all fracture facets of a patch with damage and contact of the old front, and builds their maps.
template <int D, class Lanes>
TENTPOLE_STEP void prepare_fractures(const PatchBatch& batch, const PatchWorkspace<D>& workspace,
                                     const AmplitudeSystem& system, const Lanes& lanes) {
  const ReferenceTablesView& tables = workspace.tables;
  const PatchDescriptor& patch = workspace.patch;
  share(lanes, patch.num_fractures, [&](int local) {
    const FractureFacet& facet = batch.fracture_facets[patch.first_fracture + local];
    link_fracture<D>(batch, workspace, system, local);
    lay_fracture_lines<D>(facet, batch.fracture_law, tables, pole_height<D>(batch, facet), workspace.fracture(local));
  });
  lanes.synchronize();
  share(lanes, patch.num_fractures, tables.num_lines, [&](int local) {
    const FractureFacet& facet = batch.fracture_facets[patch.first_fracture + local];
    return [&, own = workspace.fracture(local)](int line) { lay_fracture_points<D>(facet, tables, line, own); };
  });
  share(lanes, patch.num_fractures, tables.num_facet_modes + FractureWorkspace<D>::num_fields, [&](int local) {
    return [&, own = workspace.fracture(local)](int row) { clear_fracture_padding<D>(tables, own, row); };
  });
  lanes.synchronize();
  assemble_traction_maps<D>(batch.fracture_law, workspace, lanes);
}

/// What one round changed, over all fracture facets of a patch.
struct RoundChange {
  double damage = 0;
  double traction = 0;                           ///< in s*
  double largest_normal = 0;                     ///< |s0_n|
  double secant_product = 0, secant_square = 0;  ///< as in FractureLine
};

/// Damage and contact modes that follow from the waves `outgoing`; all lanes get the same change.
template <int D, class Lanes>
TENTPOLE_STEP RoundChange integrate_fractures(const PatchBatch& batch, const PatchWorkspace<D>& workspace,
                                              const double* outgoing, const Lanes& lanes) {
  const int num_lines = workspace.tables.num_lines, num_fractures = workspace.patch.num_fractures;
  load_tractions<D>(workspace, outgoing, lanes);
  share(lanes, num_fractures, num_lines, [&](int local) {
    const FractureFacet& facet = batch.fracture_facets[workspace.patch.first_fracture + local];
    return [&, own = workspace.fracture(local)](int line) {
      integrate_line<D>(facet, batch.fracture_law, workspace.tables, own, line);
    };
  });
  lanes.synchronize();
  RoundChange change;
  for (int local = 0; local < num_fractures; ++local) {
    const FractureLine* lines = workspace.fracture(local).lines;
    for (int line = 0; line < num_lines; ++line) {
      change.secant_product += lines[line].secant_product;
      change.secant_square += lines[line].secant_square;
      change.damage = larger_or_nan(change.damage, lines[line].damage_change);
      change.largest_normal = larger_or_nan(change.largest_normal, lines[line].largest_normal);
      change.traction = larger_or_nan(change.traction, lines[line].traction_change);
    }
  }
  return change;
}

/// Takes over the next damage, corrected by the secant of the last two rounds, and the next modes, and rebuilds the
/// maps: D <- next D - secant (next D - next D of the round before). secant 0: as it is; with `freeze` a point whose
/// mode flips keeps the one it has from now on.
template <int D, class Lanes>
TENTPOLE_STEP void accept_round(const FractureLaw& law, const PatchWorkspace<D>& workspace, double secant, bool freeze,
                                const Lanes& lanes) {
  share_points<D>(workspace, lanes, [&](const FractureWorkspace<D>& own, int q) {
    FracturePoint& point = own.points[q];
    const double step = point.next_damage - point.damage;
    const double damage =
        point.next_damage - secant * (point.next_damage - point.previous_damage - point.previous_step);
    point.previous_damage = point.damage;
    point.previous_step = step;
    point.damage = fmin(fmax(damage, 0.0), 1.0);
    point.is_frozen = point.is_frozen || (freeze && !(point.next_contact == point.contact));
    if (!point.is_frozen) point.contact = point.next_contact;
  });
  lanes.synchronize();
  assemble_traction_maps<D>(law, workspace, lanes);
}

/// Solves the amplitudes at the present maps: incoming = x, and the emitted waves y = t + T x into the product of the
/// coupling scratch.
template <int D, class Lanes>
inline int solve_amplitudes(const PatchWorkspace<D>& workspace, const AmplitudeSystem& system, const Lanes& lanes) {
  const CouplingScratch scratch = workspace.coupling();
  const double* outgoing = workspace.outgoing();
  const int iterations = solve_coupling(system, outgoing, workspace.incoming(), scratch, lanes);
  emit_amplitudes(system, independent_places(system), outgoing, workspace.incoming(), scratch.product, lanes);
  return iterations;
}

/// How the damage loop of a patch ended.
struct DamageLoop {
  int rounds = 0;
  int iterations = 0;  ///< of the last coupling solution, or -1
  bool has_converged = false;
};

/// Factor for accept_round that makes the sum of squared steps least if they depended linearly on D (Anderson mixing of
/// depth one, J. ACM 12 (1965) 547): 0 in the first round, and 0.3, a damping, where the change grew.
inline double secant_factor(int round, const RoundChange& change, double last_change) {
  constexpr double least = -2, largest = 0.7, damping = 0.3;
  if (round == 1 || !(change.secant_square > 0)) return 0;
  if (change.damage > last_change) return damping;
  return fmin(fmax(change.secant_product / change.secant_square, least), largest);
}

/// The damage loop: with damage and contact modes frozen the patch is linear; solve, integrate, repeat until damage
/// changes by less than 1e-10 and tractions by less than 1e-10 of the largest there is (a thousandth of the strength
/// where there is less). Plain repetition gains a digit a round and stalls where loads are just above the threshold;
/// the secant halves the rounds and needs no more than 22 for tents of ten relaxation times. Modes that still flip
/// after 10 rounds stay as they are. The maps at the end are those of the last solution.
template <int D, class Lanes>
inline DamageLoop solve_fractures(const PatchBatch& batch, const PatchWorkspace<D>& workspace,
                                  const AmplitudeSystem& system, const Lanes& lanes) {
  constexpr int max_rounds = 30, flipping_rounds = 10;
  constexpr double tolerance = 1e-10;
  const double* emitted = workspace.coupling().product;
  DamageLoop loop;
  double last_change = 0;
  while (true) {
    ++loop.rounds;
    loop.iterations = solve_amplitudes(workspace, system, lanes);
    const RoundChange change = integrate_fractures<D>(batch, workspace, emitted, lanes);
    const double scale = fmax(change.largest_normal, 1e-3 * batch.fracture_law.strength);
    loop.has_converged = change.damage < tolerance && change.traction < tolerance * scale;
    if (loop.has_converged || loop.rounds == max_rounds) return loop;
    accept_round<D>(batch.fracture_law, workspace, secant_factor(loop.rounds, change, last_change),
                    loop.rounds >= flipping_rounds, lanes);
    last_change = change.damage;
  }
}

}  // namespace tentpole
