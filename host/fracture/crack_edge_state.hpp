#pragma once

#include <array>
#include <limits>

#include "common/simplex.hpp"
#include "kernels/fracture/damage_law.hpp"

namespace tentpole {

/// A point with at least this much damage has failed; damage 1 is only approached.
inline constexpr double failed_damage = 0.999;

/// Damage counts as about to grow where a traction this many times larger than the last would make it grow.
inline constexpr double traction_margin = 1.25;

/// What a fracture edge of the front carries: values on the front at num_points Gauss points of the unit interval along
/// the edge, from the vertex of lower id to that of higher id. D = 2: num_points = k + 1. D = 1: the edge is a vertex,
/// with one point. The gap (positive: open) is taken along the normal from side minus to side plus; it keeps its
/// sign when edge or sides are exchanged.
struct CrackEdgeState {
  int num_points = 1;
  std::array<double, max_degree + 1> damage{};  ///< in [0, 1]
  std::array<double, max_degree + 1> gap{};     ///< a length
  /// Largest effective traction in the last patch on the edge; infinite until one has been solved.
  double effective_traction = std::numeric_limits<double>::infinity();
};

/// The same damage everywhere on a closed edge.
CrackEdgeState uniform_crack_edge(int num_points, double damage);

/// State of a part of the edge, from `begin` to `end` as fractions of its length: the polynomials through the values of
/// the edge, at the Gauss points of the part, damage clamped to [0, 1]. Exact where no clamping occurs. Where begin >
/// end the part runs against the edge, as it must when ids say so. A split at fraction f of edge (a, b), a < b, by
/// vertex c has parts (0, f) if a < c, else (f, 0), and (f, 1) if c < b, else (1, f).
CrackEdgeState restrict_to_part(const CrackEdgeState& edge, double begin, double end);

/// Mean over the length of the edge.
double mean_damage(const CrackEdgeState& edge);
double smallest_damage(const CrackEdgeState& edge);
double largest_damage(const CrackEdgeState& edge);
/// Part of the length that has failed: the weights of the points with damage >= failed_damage.
double failed_fraction(const CrackEdgeState& edge);
/// True if every point has failed.
bool has_failed(const CrackEdgeState& edge);
/// True where damage grows or is about to: f(traction_margin times the largest effective traction) exceeds the smallest
/// damage, and the edge has not failed. A surface that waves have left, or that stands still at D < 1, is at rest.
bool is_active(const CrackEdgeState& edge, const FractureLaw& law);

}  // namespace tentpole
