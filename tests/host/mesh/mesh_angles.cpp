#include "tests/host/mesh/mesh_angles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/mesh/simplex_geometry.hpp"

namespace tentpole::testing {

namespace {

double angle_between(const Point& a, const Point& b) {
  const double cosine = dot(a, b) / std::sqrt(dot(a, a) * dot(b, b));
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
}

AngleRange dihedral_angles(const std::array<Point, SpaceMesh::max_corners>& p) {
  AngleRange range;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) {
      int first = 0;
      while (first == i || first == j) ++first;
      const int second = 6 - i - j - first;
      const Point edge = difference(p[second], p[first]);
      const double angle =
          angle_between(cross(edge, difference(p[i], p[first])), cross(edge, difference(p[j], p[first])));
      range = {std::min(range.smallest, angle), std::max(range.largest, angle)};
    }
  return range;
}

}  // namespace

AngleRange triangle_angles(const std::array<Point, SpaceMesh::max_corners>& p) {
  AngleRange range;
  for (int i = 0; i < 3; ++i) {
    const double angle = angle_between(difference(p[(i + 1) % 3], p[i]), difference(p[(i + 2) % 3], p[i]));
    range = {std::min(range.smallest, angle), std::max(range.largest, angle)};
  }
  return range;
}

AngleRange angle_range(const SpaceMesh& mesh) {
  AngleRange range;
  for (int cell = 0; cell < mesh.num_cells(); ++cell) {
    std::array<Point, SpaceMesh::max_corners> corners{};
    for (int i = 0; i <= mesh.dimension; ++i) corners[i] = mesh.corner_position(cell, i);
    const AngleRange own = mesh.dimension == 2 ? triangle_angles(corners) : dihedral_angles(corners);
    range = {std::min(range.smallest, own.smallest), std::max(range.largest, own.largest)};
  }
  return range;
}

}  // namespace tentpole::testing
