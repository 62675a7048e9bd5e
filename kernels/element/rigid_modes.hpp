#pragma once

#include "kernels/element/element_geometry.hpp"
#include "kernels/element/reference_tables.hpp"

namespace tentpole {

/// Position on one facet in its chi modes, relative to corner 0 of the element.
template <int D>
inline void facet_position(const ElementDescriptor& element, const ReferenceTablesView& tables, int facet,
                           double (&position)[D][D + 1]) {
  constexpr int d = D + 1;
  for (int i = 0; i < D; ++i)
    for (int m = 0; m < d; ++m) position[i][m] = 0;
  for (int corner = 0, listed = 0; corner <= d; ++corner) {
    if (corner == facet) continue;
    const double* modes = tables.corner_modes + listed++ * d;
    for (int i = 0; i < D; ++i)
      for (int m = 0; m < d; ++m) position[i][m] += (element.corner[corner][i] - element.corner[0][i]) * modes[m];
  }
}

/// Rigid modes of one element over all its facets with N_t < 0: translations, then rotations about the |N_t|-weighted
/// centroid, which are orthogonal to them, by modified Gram-Schmidt in the concatenated chi modes of the facets.
template <int D>
inline void build_rigid_modes(const ElementDescriptor& element, const ReferenceTablesView& tables,
                              ElementOperator<D>& op) {
  constexpr int d = D + 1, num_rigid = ElementOperator<D>::num_rigid;
  double position[d + 1][D][d], total = 0, centroid[D] = {};
  op.num_rigid_facets = 0;
  const auto add = [&](int facet, double time_part) {
    const int f = op.num_rigid_facets++;
    op.rigid[f].facet = facet;
    op.rigid[f].root = sqrt(-time_part);
    total -= time_part;
    facet_position<D>(element, tables, facet, position[f]);
    for (int i = 0; i < D; ++i) centroid[i] -= time_part * position[f][i][0];
  };
  for (int f = 0; f < op.num_inflow; ++f) add(op.inflow[f].facet, op.inflow[f].covector[D]);
  for (int f = 0; f < op.num_inclined; ++f)
    if (op.inclined[f].time_part < 0) {
      op.inclined[f].rigid = op.num_rigid_facets;
      add(op.inclined[f].facet, op.inclined[f].time_part);
    }
  const double scale = 1 / sqrt(total);
  for (int f = 0; f < op.num_rigid_facets; ++f) {
    RigidFacet<D>& rigid = op.rigid[f];
    for (int r = 0; r < num_rigid; ++r)
      for (int i = 0; i < D; ++i)
        for (int m = 0; m < d; ++m) rigid.modes[r][i][m] = r == i && m == 0 ? rigid.root * scale : 0.0;
    for (int i = 0; i < D; ++i) position[f][i][0] -= centroid[i] / total;
    int rotation = D;
    for (int i = 0; i < D; ++i)
      for (int j = i + 1; j < D; ++j, ++rotation)
        for (int m = 0; m < d; ++m) {
          rigid.modes[rotation][i][m] = -rigid.root * position[f][j][m];
          rigid.modes[rotation][j][m] = rigid.root * position[f][i][m];
        }
  }
  const auto product = [&](int r, int s) {
    double sum = 0;
    for (int f = 0; f < op.num_rigid_facets; ++f)
      for (int i = 0; i < D; ++i)
        for (int m = 0; m < d; ++m) sum += op.rigid[f].modes[r][i][m] * op.rigid[f].modes[s][i][m];
    return sum;
  };
  for (int r = D; r < num_rigid; ++r) {
    for (int s = D; s < r; ++s) {
      const double overlap = product(r, s);
      for (int f = 0; f < op.num_rigid_facets; ++f)
        for (int i = 0; i < D; ++i)
          for (int m = 0; m < d; ++m) op.rigid[f].modes[r][i][m] -= overlap * op.rigid[f].modes[s][i][m];
    }
    const double factor = 1 / sqrt(product(r, r));
    for (int f = 0; f < op.num_rigid_facets; ++f)
      for (int i = 0; i < D; ++i)
        for (int m = 0; m < d; ++m) op.rigid[f].modes[r][i][m] *= factor;
  }
}

}  // namespace tentpole
