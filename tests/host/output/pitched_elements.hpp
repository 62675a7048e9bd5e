#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "host/output/spacetime_element.hpp"

namespace tentpole {

/// Displacement [m] at (x.., t).
using DisplacementField = std::function<std::array<double, 3>(std::span<const double>)>;

/// A box filled with tents up to a flat end time, and a displacement field projected on every element.
struct PitchedBox {
  int dimension = 2;
  int degree = 2;
  std::array<int, 3> cells{3, 3, 3};
  std::array<double, 3> length{1e-3, 1e-3, 1e-3};  ///< [m]
  double end = 1e-7;                               ///< [s]
  double tent_height = 1e-8;                       ///< [s], mean
  unsigned seed = 1;                               ///< of the vertex positions and the tent heights
  Material material{3690, 1.0e11, 1.07e11};
};

/// Elements with the coefficients they refer to.
struct PitchedElements {
  std::vector<SpacetimeElement> elements;
  std::vector<std::vector<double>> coefficients;
};

/// Always raises the lowest vertex by a random height (causality plays no part here). Cells are the simplices of Kuhn's
/// subdivision of a grid with displaced inner vertices; region 1 is the half x < length / 2, region 2 the other.
PitchedElements pitch_elements(const PitchedBox& box, const DisplacementField& field);

}  // namespace tentpole
