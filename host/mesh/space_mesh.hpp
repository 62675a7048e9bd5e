#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/index.hpp"
#include "common/simplex.hpp"

namespace tentpole {

using Point = std::array<double, max_dimension>;  ///< coordinates; those beyond the dimension are 0

/// Sides that are one and the same: (name, name) of two boundaries that differ by a translation.
using PeriodicPairs = std::vector<std::pair<std::string, std::string>>;

/// A cell and which of its corners is meant.
struct CellCorner {
  std::int32_t cell;
  std::int32_t corner;
};

/// A named side inside the domain, between cells.
struct InnerSide {
  std::string name;
  std::vector<std::array<std::int32_t, max_dimension>> facets;  ///< D vertex ids each, ascending; then `none`
};

/// A conforming simplicial mesh of the D-dimensional domain, D = 1..3. Corner i of a cell is its i-th vertex in
/// ascending vertex id, facet i is opposite corner i; corners and facets beyond D are `none`. Cells have positive
/// measure; their orientation is whatever the vertex ids give. Vertices that periodic boundaries identify are one
/// vertex here, so ids, neighbours and stars are those of the periodic domain; geometry goes through corner_position.
/// Every boundary facet has a name. Only build_space_mesh (mesh_description.hpp) makes one, and it checks all of this.
/// Units: [m] as built; any length after scale_lengths.
struct SpaceMesh {
  static constexpr int max_corners = max_dimension + 1;

  int dimension = 0;
  std::vector<Point> vertices;
  std::vector<std::array<std::int32_t, max_corners>> cells;           ///< vertex ids, ascending
  std::vector<std::array<std::uint8_t, max_corners>> corner_shift;    ///< index into shifts
  std::vector<std::int32_t> cell_region;                              ///< index into region_names
  std::vector<std::array<std::int32_t, max_corners>> neighbor;        ///< cell across facet i, or none
  std::vector<std::array<std::uint8_t, max_corners>> neighbor_facet;  ///< number of facet i seen from the neighbour
  std::vector<std::array<std::int32_t, max_corners>> facet_boundary;  ///< index into boundary_names, none inside
  std::vector<Point> shifts;                                          ///< periodic translations; shifts[0] = 0
  std::vector<std::string> region_names;
  std::vector<std::string> boundary_names;  ///< of the boundaries that have facets; periodic ones have none
  std::vector<InnerSide> inner_sides;       ///< each name once; its facets on the boundary, if any, are not listed
  std::vector<std::int32_t> star_offset;    ///< [num_vertices + 1], CSR
  std::vector<CellCorner> star_entries;     ///< cells round a vertex, ascending cell
  std::vector<std::string> warnings;        ///< what was repaired on the way in, one sentence each

  int num_vertices() const { return static_cast<int>(vertices.size()); }
  int num_cells() const { return static_cast<int>(cells.size()); }
  int num_corners() const { return dimension + 1; }

  std::span<const CellCorner> star(int vertex) const {
    return {star_entries.data() + star_offset[vertex],
            static_cast<std::size_t>(star_offset[vertex + 1] - star_offset[vertex])};
  }

  /// Where this corner lies as seen from this cell: the vertex plus its periodic shift.
  Point corner_position(int cell, int corner) const {
    const Point& vertex = vertices[cells[cell][corner]];
    const Point& shift = shifts[corner_shift[cell][corner]];
    return {vertex[0] + shift[0], vertex[1] + shift[1], vertex[2] + shift[2]};
  }

  /// Length, area or volume of a cell, > 0.
  double cell_measure(int cell) const;

  /// (measure of the domain / num_cells)^(1/D): the unit of length h0 of the scaled problem.
  double mean_cell_size() const;

  /// Multiplies all coordinates and shifts by `factor` > 0 (1 / h0 gives the scaled problem).
  void scale_lengths(double factor);
};

}  // namespace tentpole
