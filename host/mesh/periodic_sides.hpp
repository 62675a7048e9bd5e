#pragma once

#include <cstdint>
#include <vector>

#include "host/mesh/mesh_description.hpp"
#include "host/mesh/mesh_facets.hpp"

namespace tentpole {

/// Which vertices of a description are one and the same in the periodic domain.
struct PeriodicVertices {
  std::vector<std::int32_t> representative;  ///< [vertex] the smallest of those identified with it
  std::vector<std::uint8_t> shift;           ///< [vertex] its position is the representative's plus shifts[.]
  std::vector<Point> shifts;                 ///< shifts[0] = 0
};

/// Identifies the vertices and joins the facets of each pair of sides. The translation of a pair is the difference of
/// the mean positions of its vertices; each vertex must then find its partner within 1e-9 of the domain's longest side,
/// or within rounding where the domain lies far from the origin.
/// `facets` afterwards has neighbours across periodic facets, which lose their names.
/// Throws MeshError for an unknown or empty side, sides that do not match, or a cell that would meet itself.
PeriodicVertices identify_periodic_sides(const MeshDescription& description, const PeriodicPairs& periodic,
                                         FacetTable& facets);

}  // namespace tentpole
