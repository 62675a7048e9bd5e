#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "host/mesh/space_mesh.hpp"

namespace tentpole {

/// Finds points by position, up to a tolerance that is small against their distances: points are sorted into 2^20 slots
/// per axis of their bounding box, and by x within a slot, should a point far from the others put them all into one.
/// O(log n) per question.
class PointFinder {
 public:
  /// Keeps a view of `points`. Distances up to `tolerance` count as equal (largest difference of a coordinate).
  PointFinder(std::span<const Point> points, double tolerance);

  /// Smallest index of a point at this position other than `except`, or none.
  std::int32_t find(const Point& position, std::int32_t except = none) const;

  /// Tolerance for "the same place" in a domain that these points span: 1e-9 of its longest side.
  static double default_tolerance(std::span<const Point> points);

 private:
  std::int64_t slot(double coordinate, int axis) const;

  std::span<const Point> points_;
  double tolerance_;
  Point origin_{};
  double slots_per_length_ = 0;
  struct Entry {
    std::int64_t slot;  ///< of x, y, z packed
    double x;
    std::int32_t index;

    auto operator<=>(const Entry&) const = default;
  };
  std::vector<Entry> entries_;  ///< ascending
};

}  // namespace tentpole
