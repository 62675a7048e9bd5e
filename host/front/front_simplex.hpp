#pragma once

#include <array>

#include "host/mesh/space_mesh.hpp"

namespace tentpole {

/// A cell of the front with the positions and times of its corners, or one that an operation would make. D = 1 or 2;
/// the first dimension + 1 corners are used. Units: those of the mesh and its wave speeds.
struct FrontSimplex {
  static constexpr int max_corners = 3;
  int dimension = 0;
  std::array<Point, max_corners> position{};
  std::array<double, max_corners> time{};
};

/// Length or area, with the sign of the orientation.
double signed_measure(const FrontSimplex& cell);

/// grad tau of the linear function with these corner times.
Point time_gradient(const FrontSimplex& cell);

/// |grad tau|.
double time_slope(const FrontSimplex& cell);

/// The linear function tau extended to any position.
double time_at(const FrontSimplex& cell, const Point& position);

double longest_edge(const FrontSimplex& cell);

/// Height of a corner above the facet opposite to it; D = 1: the length.
double altitude(const FrontSimplex& cell, int corner);

double shortest_altitude(const FrontSimplex& cell);

/// Sine of the smallest angle; 1 for D = 1.
double smallest_angle_sine(const FrontSimplex& cell);

/// sum of squared edges / (4 sqrt(3) area): 1 for equilateral triangles, larger for others, infinite unless the area is
/// positive. 1 for D = 1.
double shape_defect(const FrontSimplex& cell);

}  // namespace tentpole
