#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/output/spacetime_element.hpp"

namespace tentpole {

/// Shape of the set t = const in a spacetime simplex. Values are the VTK cell types.
enum class SliceShape : std::uint8_t { segment = 3, triangle = 5, quad = 9, tetrahedron = 10, wedge = 13 };

/// The slice t = const of a spacetime simplex. Its vertices are the cuts of all edges from a corner below the time to
/// one above it: (corners below) x (corners above).
struct Slice {
  SliceShape shape{};
  int num_points = 0;
  std::array<std::array<double, 3>, 6> point{};  ///< [m], in VTK order, positive orientation; absent coordinates are 0
};

/// The slice of an element at `time` [s], or nothing where the element does not cover it (time_coverage.hpp) or the
/// slice has no measure. Cut points of an edge are bitwise the same in all elements that share the edge.
std::optional<Slice> slice_element(const SpacetimeElement& element, double time);

/// Length, area or volume of a slice [m^D]; positive for the orientation that slice_element gives.
double measure(const Slice& slice);

/// Space dimension of a shape.
int dimension_of(SliceShape shape);

/// The shape as a union of simplices: each entry gives dimension + 1 corners.
std::span<const std::array<int, 4>> simplices_of(SliceShape shape);

/// Determinant of the edges of one such simplex: dimension! times its measure, with the sign of its orientation.
double simplex_determinant(const Slice& slice, const std::array<int, 4>& corners);

}  // namespace tentpole
