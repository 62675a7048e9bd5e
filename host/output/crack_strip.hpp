#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "host/fracture/crack_edge_state.hpp"

namespace tentpole {

/// Contact of a fracture edge: that of most of its points in a patch.
enum class CrackMode : std::int64_t { open = 0, stick = 1, slip = 2 };

/// The part of spacetime that a fracture edge sweeps in one patch, between the old and the new front. D = 1: the edge
/// is a vertex, both ends the same.
struct CrackStrip {
  int dimension = 0;
  std::int64_t id = 0;  ///< number of the edge
  CrackMode mode = CrackMode::open;
  std::array<std::array<double, 3>, 2> end{};  ///< [m], lower vertex id first
  std::array<double, 2> old_time{};            ///< [s] of the ends on the old front
  std::array<double, 2> new_time{};            ///< [s] on the new front, >= old_time
  CrackEdgeState below, above;                 ///< damage on the two fronts

  double time_min() const;
  double time_max() const;
  /// Position [m] at a fraction of the way between the ends.
  std::array<double, 3> position(double fraction) const;
  /// Length [m] of the edge; D = 1: 1.
  double measure() const;
};

/// Fractions between which an edge lies at a time.
struct StripPart {
  double begin, end;  ///< 0 <= begin < end <= 1
};

/// The part of the edge that answers for `time` [s] with this strip: where old front < time <= new front, as elements
/// do (time_coverage.hpp). Nothing where that is no more than a point.
std::optional<StripPart> part_at(const CrackStrip& strip, double time);

/// Damage of that part at that time, at its Gauss points: linear in time along each line between the two fronts.
CrackEdgeState damage_at(const CrackStrip& strip, const StripPart& part, double time);

}  // namespace tentpole
