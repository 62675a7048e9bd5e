#pragma once

#include <array>
#include <random>
#include <vector>

#include "common/simplex.hpp"

namespace tentpole {

/// A tent: the cells around one vertex of a front, and how high the vertex rises. Vertex ids are in random order; the
/// pole stands near the origin and cells are about 1 across.
struct TentGeometry {
  int dimension = 0;
  std::vector<std::array<double, max_dimension>> position;  ///< [vertex]
  std::vector<double> time;                                 ///< [vertex], the old front
  std::vector<std::array<int, max_dimension + 1>> cells;    ///< [cell], D + 1 ascending vertices, all contain `pole`
  int pole = 0;
  double top_time = 0;
};

/// Random vertex ids, so that the pole takes any place in the ascending corners of its cells; all times zero.
void shuffle_vertices(TentGeometry& tent, std::mt19937& generator);

/// D = 1: the pole between two cells, or at the end of one. The front is flat (time 0) until raise_tent.
TentGeometry line_star(bool at_boundary, std::mt19937& generator);

/// D = 2: a ring of triangles around the pole, or at the boundary a chain, whose angles at the pole lie in the range.
TentGeometry fan_star(bool at_boundary, double min_angle_degrees, double max_angle_degrees, std::mt19937& generator);

/// D = 3: a cube of jittered corners and face centres, every face cut into four triangles that form tetrahedra with the
/// pole; at the boundary one to five of the faces. Heights are multiplied by `flatness`: small values give slivers.
TentGeometry cube_star(bool at_boundary, double flatness, std::mt19937& generator);

/// Any of the three stars by dimension.
struct StarShape {
  double min_angle_degrees = 20;
  double max_angle_degrees = 130;
  double flatness = 1;
};
TentGeometry random_star(int dimension, bool at_boundary, const StarShape& shape, std::mt19937& generator);

/// Gives the vertices a random causal old front with max |grad tau| c_p = steepness, and the top `height_fraction` of
/// the way from the pole's time to the causal limit |grad tau| c_p = 0.95 of the new front. wave_speed: c_p [cell].
void raise_tent(TentGeometry& tent, const std::vector<double>& wave_speed, double steepness, double height_fraction,
                std::mt19937& generator);

}  // namespace tentpole
