#include "bench/assembly/element_updates.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/element/orthonormal_basis.hpp"
#include "kernels/reference/rigid_modes.reference.hpp"

namespace tentpole {
namespace {

using reference::Matrix;
using reference::Vector;

/// A unit normal and D - 1 unit tangents, from the spatial part of the covector of a vertical facet.
Matrix orthonormal_frame(const Vector& covector, double area, int dimension) {
  Matrix frame{};
  for (int i = 0; i < dimension; ++i) frame[0][i] = covector[i] / area;
  for (int c = 1, axis = 0; c < dimension; ++axis) {
    Vector tangent{};
    tangent[axis] = 1;
    for (int other = 0; other < c; ++other) {
      const double along = frame[other][axis];
      for (int i = 0; i < dimension; ++i) tangent[i] -= along * frame[other][i];
    }
    double square = 0;
    for (int i = 0; i < dimension; ++i) square += tangent[i] * tangent[i];
    if (square < 0.1) continue;
    for (int i = 0; i < dimension; ++i) frame[c][i] = tangent[i] / std::sqrt(square);
    ++c;
  }
  return frame;
}

}  // namespace

ElementUpdates::ElementUpdates(const CellTables& tables, const PatchBatch& batch, int element, bool with_neighbors)
    : tables_(&tables),
      index_(element),
      element_(&batch.elements[element]),
      material_(batch.materials[element_->material]),
      geometry_(reference::element_geometry(*element_, tables.dimension)),
      neighbor_inverse_(tables.dimension + 2),
      covector_(tables.dimension + 2),
      frame_(tables.dimension + 2),
      area_(tables.dimension + 2) {
  const int D = tables.dimension;
  add_segment(Kind::volume, 0, tables.num_volume_points());
  for (int facet = 0; facet <= D + 1; ++facet) {
    covector_[facet] = reference::facet_covector(geometry_, D, facet);
    const FacetKind kind = element_->facet_kind[facet];
    if (kind == FacetKind::inflow) add_segment(Kind::inflow, facet, tables.num_facet_points());
    if (kind != FacetKind::interior && kind != FacetKind::boundary) continue;
    for (int j = 0; j < D; ++j) area_[facet] += covector_[facet][j] * covector_[facet][j];
    area_[facet] = std::sqrt(area_[facet]);
    frame_[facet] = orthonormal_frame(covector_[facet], area_[facet], D);
    add_segment(Kind::vertical, facet, tables.num_facet_points());
  }
  add_segment(Kind::rigid, 0, 1);
  add_rigid_moments();
  for (int facet = 0; facet <= D + 1 && with_neighbors; ++facet) {
    if (element_->facet_kind[facet] != FacetKind::interior) continue;
    neighbor_inverse_[facet] = reference::element_geometry(batch.elements[element_->neighbor[facet]], D).inverse;
    add_segment(Kind::neighbor, facet, tables.num_facet_points());
  }
}

void ElementUpdates::add_segment(Kind kind, int facet, int num_updates) {
  segments_.push_back({kind, facet, size_});
  size_ += num_updates;
}

const ElementUpdates::Segment& ElementUpdates::segment_of(int update) const {
  std::size_t index = segments_.size() - 1;
  while (segments_[index].first > update) --index;
  return segments_[index];
}

int ElementUpdates::column_element(int update) const {
  const Segment& segment = segment_of(update);
  return segment.kind == Kind::neighbor ? element_->neighbor[segment.facet] : index_;
}

// moments_r[(i, a)] = sum over the facets with N_t < 0 of |N_t| <mode_r,i phi_a>; the update is sum_r m_r m_r^T.
void ElementUpdates::add_rigid_moments() {
  using namespace reference;
  const int D = tables_->dimension, num_basis = tables_->num_basis;
  const Discretization disc(D, tables_->degree);
  const std::vector<EntryFacet> entries = entry_facets(disc, *element_);
  const std::vector<std::vector<Rows>> modes = rigid_modes(disc, *element_, entries);
  rigid_moments_.assign(modes.size() * tables_->num_unknowns, 0.0);
  Row value(num_basis);
  for (std::size_t f = 0; f < entries.size(); ++f)
    for (int q = 0; q < disc.facet_rule.num_points(); ++q) {
      disc.basis.values(element_point(facet_barycentric(disc, q), facet_corners(D, entries[f].facet)), value);
      const double weight = entries[f].weight * disc.facet_rule.weights[q];
      for (std::size_t r = 0; r < modes.size(); ++r)
        for (int i = 0; i < D; ++i)
          for (int a = 0; a < num_basis; ++a)
            rigid_moments_[r * tables_->num_unknowns + i * num_basis + a] += weight * modes[r][f][q][i] * value[a];
    }
}

}  // namespace tentpole
