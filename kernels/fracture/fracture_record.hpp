#pragma once

#include "kernels/fracture/fracture_loop.hpp"

namespace tentpole {

/// Means over a fracture facet.
struct FractureSums {
  double work = 0;        ///< s*.(v*_1 - v*_0)
  double friction = 0;    ///< the part of it that friction takes
  double excess[2] = {};  ///< of s*_c beyond the facet's modes, squared
};

/// s* = M s0 at a point and the modes that the elements feel of it: v*_1 - v*_0 = (1 / Z_0 + 1 / Z_1)(s0 - s*), so the
/// work is nowhere negative.
template <int D>
inline void add_point(const FractureLaw& law, const ReferenceTablesView& tables, const FractureWorkspace<D>& workspace,
                      int q, FractureSums& sums) {
  const FractureLink& link = *workspace.link;
  const FracturePoint& point = workspace.points[q];
  const PointTraction traction = traction_at<D>(workspace, q);
  const TractionMap map = traction_map(law, point.contact, point.damage, link.normal_sign);
  const double intact[2] = {traction.normal, traction.tangential};
  const double target[2] = {map.normal * traction.normal,
                            map.tangential * traction.tangential + map.friction * traction.normal};
  for (int c = 0; c < D; ++c) {
    const double opening = link.compliance(c) * (intact[c] - target[c]);
    sums.work += point.weight * target[c] * opening;
    if (c > 0) sums.friction += point.weight * map.friction * traction.normal * opening;
    const double excess = target[c] - value_at<D>(workspace, workspace.target, tables.num_facet_modes, c, q);
    sums.excess[c] += point.weight * excess * excess;
  }
}

/// Fills the record of one fracture facet from the waves of the final solution, and adds to the dissipation of its two
/// elements what the modes of element_residual leave out: int (s* - s).Z^-1 (s* - s) also of the part of s* that is no
/// polynomial of degree k - 1. The points integrate products of modes exactly, so this part is orthogonal to the rest.
template <int D>
inline void record_fracture(const PatchBatch& batch, const PatchWorkspace<D>& workspace, int local, int rounds,
                            Status status) {
  const PatchDescriptor& patch = workspace.patch;
  const ReferenceTablesView& tables = workspace.tables;
  const FractureWorkspace<D> own = workspace.fracture(local);
  const FractureLink& link = *own.link;
  const FractureFacet& facet = batch.fracture_facets[patch.first_fracture + local];
  FractureRecord record{};
  record.rounds = rounds;
  record.status = static_cast<int>(status);
  for (int line = 0; line < tables.num_lines; ++line) {
    record.damage[line] = own.lines[line].end_damage;
    record.gap[line] = own.lines[line].end_gap;
    record.largest_damage_change = fmax(record.largest_damage_change, record.damage[line] - facet.damage[line]);
  }
  FractureSums sums;
  for (int q = 0; q < own.num_points(tables); ++q) {
    const PointTraction traction = traction_at<D>(own, q);
    record.largest_effective_traction =
        fmax(record.largest_effective_traction,
             effective_traction(batch.fracture_law, link.normal_sign * traction.normal, traction.tangential));
    ++record.mode_points[static_cast<int>(own.points[q].contact.mode)];
    add_point<D>(batch.fracture_law, tables, own, q, sums);
  }
  record.friction_work = link.measure * sums.friction;
  record.fracture_work = link.measure * (sums.work - sums.friction);
  batch.fracture_records[patch.first_fracture + local] = record;
  for (int side = 0; side < 2; ++side)
    for (int c = 0; c < D; ++c)
      batch.records[facet.element[side]].dissipation += link.measure * sums.excess[c] / link.impedance[side][c];
}

/// Records of all fracture facets of a solved patch from the waves that its elements emit, after their own records. One
/// lane makes them all, since two facets may add to one element.
template <int D, class Lanes>
TENTPOLE_STEP void record_fractures(const PatchBatch& batch, const PatchWorkspace<D>& workspace, int rounds,
                                    Status status, const Lanes& lanes) {
  const int num_fractures = workspace.patch.num_fractures;
  if (num_fractures == 0) return;
  load_tractions<D>(workspace, workspace.outgoing(), lanes);
  share(lanes, num_fractures, workspace.links()[0].size(), [&](int local) {
    return [own = workspace.fracture(local)](int entry) { own.target[entry] = target_entry(*own.link, entry); };
  });
  lanes.synchronize();
  if (lanes.first() == 0)
    for (int local = 0; local < num_fractures; ++local) record_fracture<D>(batch, workspace, local, rounds, status);
  lanes.synchronize();
}

}  // namespace tentpole
