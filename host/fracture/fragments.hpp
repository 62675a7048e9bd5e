#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tentpole {

/// A facet with this much damage everywhere separates the cells beside it.
inline constexpr double separating_damage = 0.99;

/// Two cells with a common facet; damage 0 where the facet is no fracture surface, otherwise the smallest damage on it.
struct CellConnection {
  std::int32_t first, second;
  double damage;
};

/// What a cell carries: volume (D = 2: area, D = 1: length), mass int rho and momentum int rho v over it.
struct CellContent {
  double volume;
  double mass;
  std::array<double, 3> momentum;
};

/// A part of the body that hangs together.
struct Fragment {
  std::int32_t num_cells = 0;
  std::int32_t first_cell = 0;  ///< its smallest cell number
  CellContent content{};        ///< sums over its cells

  /// Mean velocity, momentum over mass; zero for a fragment without mass.
  std::array<double, 3> velocity() const;
};

struct Fragments {
  std::vector<Fragment> fragments;             ///< ascending in first_cell
  std::vector<std::int32_t> fragment_of_cell;  ///< [cells], index into fragments
};

/// Connected components of cells when facets with damage >= separating_damage are cut. The result does not depend on
/// the order of the connections. Units of the content as given. Connections name cells of `cells`.
Fragments find_fragments(std::span<const CellContent> cells, std::span<const CellConnection> connections);

}  // namespace tentpole
