#pragma once

#include <array>
#include <random>
#include <vector>

#include "tests/kernels/tent_geometry.hpp"

namespace tentpole {

/// A patch of any kind as a set of spacetime simplices on numbered vertices.
struct PatchGeometry {
  struct Element {
    std::array<int, max_dimension + 2> corners;  ///< D + 2 ascending vertices; of a tent element the top is the last
    int pole;                                    ///< corner that is the bottom of the tent pole, or none
  };
  int dimension = 0;
  std::vector<std::array<double, max_dimension>> position;  ///< [vertex]
  std::vector<double> time;                                 ///< [vertex]
  std::vector<Element> elements;

  /// Whether an interior facet may be inclined: not so for tents whose top stands straight above its bottom.
  bool is_general() const;
};

/// The elements over the cells of a tent, its top as an additional, last vertex.
PatchGeometry tent_patch(const TentGeometry& tent);

/// A random star whose pole rises and moves at `pole_speed`; height_fraction of the largest height at which the patch
/// is admissible (below). At a boundary (D = 2) the star is a half disc and the pole slides along its straight side.
PatchGeometry inclined_tent(int dimension, bool at_boundary, double wave_speed, double pole_speed,
                            double height_fraction, std::mt19937& generator);

/// Deletion of a vertex: the cells around it, below the new cells of its link, D = 1 or 2. All elements are cones with
/// the vertex as apex. At a boundary (D = 2) the vertex lies on a straight side.
PatchGeometry deletion_cone(int dimension, bool at_boundary, double wave_speed, std::mt19937& generator);

/// D = 2: a vertex at the centre of a square, deleted: the one inner facet stands on a diagonal through the vertex and
/// is parallel to the time axis, between two general elements.
PatchGeometry square_cone(double wave_speed, std::mt19937& generator);

/// Flip of the edge between two triangles, D = 2: one element between the old edge and the new edge above it.
PatchGeometry edge_flip(double wave_speed, std::mt19937& generator);

/// Whether volumes are positive, the two elements at an inner facet lie on its two sides, and every facet that belongs
/// to one element is parallel to the time axis or has |N_x| c_p <= 0.95 |N_t|.
bool is_admissible(const PatchGeometry& patch, double wave_speed);

}  // namespace tentpole
