#include "host/fracture/planar_orientation.hpp"

namespace tentpole {

double signed_double_area(const Point& first, const Point& second, const Point& point) {
  if (second < first) return -signed_double_area(second, first, point);
  return (second[0] - first[0]) * (point[1] - first[1]) - (second[1] - first[1]) * (point[0] - first[0]);
}

bool is_in_triangle(std::span<const Point> corners, const Point& point) {
  bool left = true, right = true;
  for (int side = 0; side < 3; ++side) {
    const double area = signed_double_area(corners[side], corners[(side + 1) % 3], point);
    left = left && area >= 0;
    right = right && area <= 0;
  }
  return left || right;
}

}  // namespace tentpole
