#include "host/mesh/point_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tentpole {

namespace {

constexpr std::int64_t num_slots = std::int64_t{1} << 20;

std::int64_t pack(std::int64_t x, std::int64_t y, std::int64_t z) {
  return (x * num_slots + y) * num_slots + z;
}

std::pair<Point, Point> bounding_box(std::span<const Point> points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  for (const Point& point : points)
    for (int axis = 0; axis < max_dimension; ++axis) {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  return {low, high};
}

double longest_side(const Point& low, const Point& high) {
  return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 0.0});
}

}  // namespace

double PointFinder::default_tolerance(std::span<const Point> points) {
  const auto [low, high] = bounding_box(points);
  return 1e-9 * longest_side(low, high);
}

PointFinder::PointFinder(std::span<const Point> points, double tolerance) : points_(points), tolerance_(tolerance) {
  const auto [low, high] = bounding_box(points);
  const double side = longest_side(low, high);
  origin_ = low;
  // Finite even for a side that is no normal number: its product with a length must be a number.
  slots_per_length_ = side > 0 ? std::min((num_slots - 1) / side, std::numeric_limits<double>::max()) : 0;
  entries_.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    entries_.push_back({pack(slot(p[0], 0), slot(p[1], 1), slot(p[2], 2)), p[0], static_cast<std::int32_t>(i)});
  }
  std::sort(entries_.begin(), entries_.end());
}

std::int64_t PointFinder::slot(double coordinate, int axis) const {
  const double position = std::clamp((coordinate - origin_[axis]) * slots_per_length_, 0.0, num_slots - 1.0);
  return static_cast<std::int64_t>(position);
}

std::int32_t PointFinder::find(const Point& position, std::int32_t except) const {
  std::array<std::int64_t, max_dimension> first{}, last{};
  for (int axis = 0; axis < max_dimension; ++axis) {
    first[axis] = slot(position[axis] - tolerance_, axis);
    last[axis] = slot(position[axis] + tolerance_, axis);
  }
  std::int32_t found = none;
  for (std::int64_t x = first[0]; x <= last[0]; ++x)
    for (std::int64_t y = first[1]; y <= last[1]; ++y)
      for (std::int64_t z = first[2]; z <= last[2]; ++z) {
        const std::int64_t key = pack(x, y, z);
        auto entry = std::lower_bound(entries_.begin(), entries_.end(), Entry{key, position[0] - tolerance_, none});
        for (; entry != entries_.end() && entry->slot == key && entry->x <= position[0] + tolerance_; ++entry) {
          const Point& point = points_[entry->index];
          const bool same = std::abs(point[0] - position[0]) <= tolerance_ &&
                            std::abs(point[1] - position[1]) <= tolerance_ &&
                            std::abs(point[2] - position[2]) <= tolerance_;
          if (same && entry->index != except && (found == none || entry->index < found)) found = entry->index;
        }
      }
  return found;
}

}  // namespace tentpole
