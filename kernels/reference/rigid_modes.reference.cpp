#include "kernels/reference/rigid_modes.reference.hpp"

#include <cmath>

#include "kernels/reference/inclined_facet.reference.hpp"

namespace tentpole::reference {
namespace {

using Mode = std::vector<Rows>;  ///< [entry][q][i]

/// sum over the facets of weight times the mean of a . b.
double product(const Discretization& disc, const std::vector<EntryFacet>& entries, const Mode& a, const Mode& b) {
  double sum = 0;
  for (std::size_t f = 0; f < entries.size(); ++f)
    for (int q = 0; q < disc.facet_rule.num_points(); ++q)
      for (int i = 0; i < disc.dimension; ++i)
        sum += entries[f].weight * disc.facet_rule.weights[q] * a[f][q][i] * b[f][q][i];
  return sum;
}

/// mode += factor other
void add(Mode& mode, double factor, const Mode& other) {
  for (std::size_t f = 0; f < mode.size(); ++f)
    for (std::size_t q = 0; q < mode[f].size(); ++q)
      for (std::size_t i = 0; i < mode[f][q].size(); ++i) mode[f][q][i] += factor * other[f][q][i];
}

void scale(Mode& mode, double factor) {
  for (Rows& facet : mode)
    for (Row& point : facet)
      for (double& component : point) component *= factor;
}

/// Weighted mean position of the entry facets: about it rotations are orthogonal to translations.
Vector centroid(const Discretization& disc, const ElementDescriptor& element, const std::vector<EntryFacet>& entries) {
  Vector sum{};
  double weight = 0;
  for (const EntryFacet& entry : entries) {
    weight += entry.weight;
    for (const int corner : facet_corners(disc.dimension, entry.facet))
      for (int j = 0; j < disc.dimension; ++j)
        sum[j] += entry.weight * element.corner[corner][j] / (disc.dimension + 1);
  }
  for (double& coordinate : sum) coordinate /= weight;
  return sum;
}

}  // namespace

std::vector<EntryFacet> entry_facets(const Discretization& disc, const ElementDescriptor& element) {
  const Geometry geometry = element_geometry(element, disc.dimension);
  std::vector<EntryFacet> entries;
  for (int facet = 0; facet <= disc.dimension + 1; ++facet) {
    const double time_part = facet_covector(geometry, disc.dimension, facet)[disc.dimension];
    const bool enters = element.facet_kind[facet] == FacetKind::inflow || is_inclined(disc, element, facet);
    if (enters && time_part < 0) entries.push_back({facet, -time_part});
  }
  return entries;
}

std::vector<std::vector<Rows>> rigid_modes(const Discretization& disc, const ElementDescriptor& element,
                                           const std::vector<EntryFacet>& entries) {
  const int D = disc.dimension, num_points = disc.facet_rule.num_points();
  std::vector<Mode> modes(num_symmetric(D), Mode(entries.size(), Rows(num_points, Row(D, 0.0))));
  const Vector origin = centroid(disc, element, entries);
  for (std::size_t f = 0; f < entries.size(); ++f)
    for (int q = 0; q < num_points; ++q) {
      const Row barycentric = facet_barycentric(disc, q);
      const std::vector<int> corners = facet_corners(D, entries[f].facet);
      Vector from_origin{};
      for (int c = 0; c <= D; ++c)
        for (int j = 0; j < D; ++j) from_origin[j] += barycentric[c] * (element.corner[corners[c]][j] - origin[j]);
      int rotation = D;
      for (int i = 0; i < D; ++i) {
        modes[i][f][q][i] = 1;
        for (int j = i + 1; j < D; ++j, ++rotation) {
          modes[rotation][f][q][i] = -from_origin[j];
          modes[rotation][f][q][j] = from_origin[i];
        }
      }
    }
  for (std::size_t r = 0; r < modes.size(); ++r) {
    for (std::size_t s = 0; s < r; ++s) add(modes[r], -product(disc, entries, modes[r], modes[s]), modes[s]);
    scale(modes[r], 1 / std::sqrt(product(disc, entries, modes[r], modes[r])));
  }
  return modes;
}

}  // namespace tentpole::reference
