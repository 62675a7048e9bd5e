#include "host/output/slice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "host/output/time_coverage.hpp"

namespace tentpole {
namespace {

using Point = std::array<double, 3>;

/// Slices smaller than this part of (largest extent of the element)^D count as points, lines or planes.
constexpr double negligible_measure = 1e-14;

struct Corners {
  std::array<int, 5> index{};
  int count = 0;
  void add(int corner) { index[count++] = corner; }
};

/// Where the edge from corner `below` to corner `above` meets `time`; exact at both ends.
Point cut_edge(const SpacetimeElement& element, int below, int above, double time) {
  const int dimension = element.dimension;
  const auto &low = element.corner[below], &high = element.corner[above];
  const double s = (time - low[dimension]) / (high[dimension] - low[dimension]);
  Point point{};
  for (int i = 0; i < dimension; ++i) point[i] = (1 - s) * low[i] + s * high[i];
  return point;
}

SliceShape shape_of(int dimension, int num_points) {
  switch (dimension) {
    case 1:
      return SliceShape::segment;
    case 2:
      return num_points == 3 ? SliceShape::triangle : SliceShape::quad;
    default:
      return num_points == 4 ? SliceShape::tetrahedron : SliceShape::wedge;
  }
}

/// Turns a slice of negative orientation round.
void reverse(Slice& slice) {
  auto& point = slice.point;
  switch (slice.shape) {
    case SliceShape::segment:
      std::swap(point[0], point[1]);
      break;
    case SliceShape::quad:
      std::swap(point[1], point[3]);
      break;
    case SliceShape::wedge:
      std::swap(point[4], point[5]);
      [[fallthrough]];
    case SliceShape::triangle:
    case SliceShape::tetrahedron:
      std::swap(point[1], point[2]);
      break;
  }
}

double largest_extent(const SpacetimeElement& element) {
  double extent = 0;
  for (int i = 0; i < element.dimension; ++i)
    for (int corner = 1; corner < element.dimension + 2; ++corner)
      extent = std::max(extent, std::abs(element.corner[corner][i] - element.corner[0][i]));
  return extent;
}

/// All cut points, in VTK order: the side with two corners runs slowest, and the second half of a quad backwards.
Slice cut(const SpacetimeElement& element, const Corners& below, const Corners& above, double time) {
  Slice slice;
  const bool above_slowest = above.count < below.count;
  const Corners &slow = above_slowest ? above : below, &fast = above_slowest ? below : above;
  for (int i = 0; i < slow.count; ++i)
    for (int j = 0; j < fast.count; ++j) {
      const int low = above_slowest ? fast.index[j] : slow.index[i],
                high = above_slowest ? slow.index[i] : fast.index[j];
      slice.point[slice.num_points++] = cut_edge(element, low, high, time);
    }
  slice.shape = shape_of(element.dimension, slice.num_points);
  if (slice.shape == SliceShape::quad) std::swap(slice.point[2], slice.point[3]);
  return slice;
}

}  // namespace

int dimension_of(SliceShape shape) {
  if (shape == SliceShape::segment) return 1;
  return shape == SliceShape::triangle || shape == SliceShape::quad ? 2 : 3;
}

std::span<const std::array<int, 4>> simplices_of(SliceShape shape) {
  static constexpr std::array<int, 4> whole[] = {{0, 1, 2, 3}};
  static constexpr std::array<int, 4> quad[] = {{0, 1, 2, 0}, {0, 2, 3, 0}};
  // VTK takes a wedge as positive when the normal of its first triangle points outwards.
  static constexpr std::array<int, 4> wedge[] = {{0, 2, 1, 4}, {0, 2, 4, 5}, {0, 5, 4, 3}};
  if (shape == SliceShape::quad) return quad;
  if (shape == SliceShape::wedge) return wedge;
  return whole;
}

double simplex_determinant(const Slice& slice, const std::array<int, 4>& corners) {
  const int dimension = dimension_of(slice.shape);
  std::array<Point, 3> edge{};
  for (int l = 0; l < dimension; ++l)
    for (int i = 0; i < dimension; ++i) edge[l][i] = slice.point[corners[l + 1]][i] - slice.point[corners[0]][i];
  if (dimension == 1) return edge[0][0];
  if (dimension == 2) return edge[0][0] * edge[1][1] - edge[0][1] * edge[1][0];
  return edge[0][0] * (edge[1][1] * edge[2][2] - edge[1][2] * edge[2][1]) -
         edge[0][1] * (edge[1][0] * edge[2][2] - edge[1][2] * edge[2][0]) +
         edge[0][2] * (edge[1][0] * edge[2][1] - edge[1][1] * edge[2][0]);
}

double measure(const Slice& slice) {
  const std::array<double, 4> factorial = {1, 1, 2, 6};
  double sum = 0;
  for (const auto& corners : simplices_of(slice.shape)) sum += simplex_determinant(slice, corners);
  return sum / factorial[dimension_of(slice.shape)];
}

std::optional<Slice> slice_element(const SpacetimeElement& element, double time) {
  const double time_min = element.time_min();
  if (!covers(time_min, element.time_max(), time)) return std::nullopt;
  // A corner exactly at `time` belongs to the upper side, except at the initial time, where the element lies above.
  Corners below, above;
  for (int corner = 0; corner < element.dimension + 2; ++corner) {
    const double corner_time = element.corner[corner][element.dimension];
    (corner_time < time || (time == time_min && corner_time == time) ? below : above).add(corner);
  }
  if (above.count == 0) return std::nullopt;  // the whole element at one time: no volume, hence no slice of its own
  Slice slice = cut(element, below, above, time);
  const double size = measure(slice);
  if (!(std::abs(size) > negligible_measure * std::pow(largest_extent(element), element.dimension)))
    return std::nullopt;
  if (size < 0) reverse(slice);
  return slice;
}

}  // namespace tentpole
