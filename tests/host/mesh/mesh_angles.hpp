#pragma once

#include <array>

#include "host/mesh/space_mesh.hpp"

namespace tentpole::testing {

/// Smallest and largest of some angles [degrees].
struct AngleRange {
  double smallest = 180;
  double largest = 0;
};

/// The angles of a triangle.
AngleRange triangle_angles(const std::array<Point, SpaceMesh::max_corners>& corners);

/// The angles (D = 2) or dihedral angles (D = 3) of all cells of a mesh.
AngleRange angle_range(const SpaceMesh& mesh);

}  // namespace tentpole::testing
