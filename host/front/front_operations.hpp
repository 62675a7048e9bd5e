#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "host/front/front_mesh.hpp"

namespace tentpole {

/// The cells that an operation replaces, as they were when it was planned. While their serials live on, the operation
/// may be carried out: in a round only splits come between planning and committing.
struct FootprintCell {
  std::int32_t cell;
  std::int64_t serial;
};
using Footprint = std::vector<FootprintCell>;

/// Top of an inclined tent pole.
struct InclinedTent {
  Point position;
  double time;
};

/// What plan_deletion may make.
struct DeletionLimits {
  double smallest_angle = 15;                                     ///< [degrees], D = 2
  double longest_edge = std::numeric_limits<double>::infinity();  ///< of every new cell
};

/// A spacetime element between vertices of the front, each at its time: D + 2 of them, ascending, then `none`.
struct SpacetimeSimplex {
  std::array<std::int32_t, FrontSimplex::max_corners + 1> vertex;
  std::int32_t region;
};

/// An operation that replaces cells of the front: spacetime simplices fill the space between those that end and those
/// that begin. A facet of an element is on a cell below (inflow), on a cell above (outflow), shared with another
/// element, or on the boundary.
struct CellExchange {
  Footprint below;                  ///< ascending cell
  std::vector<NewFrontCell> above;  ///< corners ascending
  std::vector<SpacetimeSimplex> between;
  std::vector<NewBoundaryFacet> boundary;  ///< facets that take the place of several
};

/// Edge flip: one tetrahedron with the two old cells below and the two new ones above.
struct FlipPlan {
  CellExchange exchange;
  std::array<std::int32_t, 2> diagonal;  ///< the edge that takes the place of the old one, ascending
  double angle_gain;                     ///< rise of the smallest angle's sine
};

/// One cell cut in two. Corner numbers are those of the parent; its slot may hold one of the children by now.
struct CellSplit {
  std::int32_t parent;
  std::int64_t parent_serial;
  FrontVertices parent_vertex;
  std::int32_t lower_corner, higher_corner;  ///< ends of the cut edge, lower_corner < higher_corner
  double fraction;                           ///< where the new vertex lies, from the lower to the higher corner
  std::int32_t vertex;                       ///< the new one
  std::array<std::int32_t, 2> child;         ///< the one that keeps the lower corner, the one that keeps the higher
  std::array<std::int64_t, 2> child_serial;
};

/// One crack edge cut in two.
struct EdgeSplit {
  std::int32_t lower, higher;        ///< ends, ascending vertex id
  std::int32_t vertex;               ///< the new one
  double fraction;                   ///< from lower to higher
  std::int32_t crack_edge;           ///< number of the edge that was cut, retired now
  std::array<std::int32_t, 2> half;  ///< numbers of (lower, vertex) and (higher, vertex)
};

/// What a call did, in the order done. Where the wanted split was refused, closure splits may have been done before.
struct SplitOutcome {
  bool is_done = false;
  std::vector<CellSplit> cells;
  std::vector<EdgeSplit> crack_edges;
};

}  // namespace tentpole
