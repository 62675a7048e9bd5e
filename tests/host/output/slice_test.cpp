#include "host/output/slice.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/output/slice_cells.hpp"
#include "tests/host/output/pitched_elements.hpp"
#include "tests/host/output/sample_fields.hpp"
#include "tests/host/output/slice_energy.hpp"

namespace tentpole {
namespace {

PitchedBox box_of(int dimension) {
  PitchedBox box;
  box.dimension = dimension;
  box.degree = 2;
  box.cells = {4, 3, 2};
  box.end = 5e-8;
  return box;
}

double box_measure(const PitchedBox& box) {
  return std::pow(box.length[0], box.dimension);
}

/// A tetrahedron in (x, y, t) with its base at t = 0 and its top at t = 1.
SpacetimeElement unit_tent() {
  SpacetimeElement element;
  element.dimension = 2;
  element.corner = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  return element;
}

/// Edges (0,0)-(1,0) at t = 0 and (0,0)-(0,1) at t = 1: slices in between are rectangles.
SpacetimeElement unit_flip() {
  SpacetimeElement element;
  element.dimension = 2;
  element.corner = {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 1}}};
  return element;
}

TEST(Slice, OfATentIsTheShrinkingTriangle) {
  const auto slice = slice_element(unit_tent(), 0.25);
  ASSERT_TRUE(slice);
  EXPECT_EQ(slice->shape, SliceShape::triangle);
  EXPECT_DOUBLE_EQ(measure(*slice), 0.5 * 0.75 * 0.75);
}

TEST(Slice, OfAFlipIsARectangleInCyclicOrder) {
  const auto slice = slice_element(unit_flip(), 0.25);
  ASSERT_TRUE(slice);
  EXPECT_EQ(slice->shape, SliceShape::quad);
  EXPECT_DOUBLE_EQ(measure(*slice), 0.25 * 0.75);
  for (int i = 0; i < 4; ++i) {  // neighbours in the cycle share one coordinate
    const auto &a = slice->point[i], &b = slice->point[(i + 1) % 4];
    EXPECT_TRUE((a[0] == b[0]) != (a[1] == b[1]));
  }
}

TEST(Slice, CoversTheInitialTimeButNoOtherLowerEnd) {
  SpacetimeElement element = unit_tent();
  ASSERT_TRUE(slice_element(element, 0));
  EXPECT_DOUBLE_EQ(measure(*slice_element(element, 0)), 0.5);
  for (auto& corner : element.corner) corner[2] += 1;
  EXPECT_FALSE(slice_element(element, 1));
}

TEST(Slice, AtAPointOrAnEdgeIsDropped) {
  EXPECT_FALSE(slice_element(unit_tent(), 1));
  EXPECT_FALSE(slice_element(unit_flip(), 1));
  EXPECT_FALSE(slice_element(unit_flip(), 0));
  EXPECT_FALSE(slice_element(unit_flip(), 1.5));
}

TEST(Slice, OfAllElementsCoverTheDomainAtAnyTime) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    const PitchedBox box = box_of(dimension);
    const PitchedElements pitched = pitch_elements(box, quadratic_field(dimension));
    for (const double share : {0.0, 0.1, 1.0 / 3, 0.5, 0.77, 1.0}) {
      double sum = 0;
      for (const SpacetimeElement& element : pitched.elements)
        if (const auto slice = slice_element(element, share * box.end)) sum += measure(*slice);
      EXPECT_NEAR(sum / box_measure(box), 1, 1e-12) << "D = " << dimension << ", t = " << share << " end";
    }
  }
}

TEST(Slice, CoverAVertexTimeExactly) {
  const PitchedBox box = box_of(2);
  const PitchedElements pitched = pitch_elements(box, quadratic_field(2));
  const double time = pitched.elements[pitched.elements.size() / 2].time_max();
  double sum = 0;
  for (const SpacetimeElement& element : pitched.elements)
    if (const auto slice = slice_element(element, time)) sum += measure(*slice);
  EXPECT_NEAR(sum / box_measure(box), 1, 1e-12);
}

TEST(SliceCells, KeepMeasureAndOrientation) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    const PitchedBox box = box_of(dimension);
    const PitchedElements pitched = pitch_elements(box, quadratic_field(dimension));
    for (const SpacetimeElement& element : pitched.elements) {
      const auto slice = slice_element(element, 0.4 * box.end);
      if (!slice) continue;
      for (int n = 1; n <= (dimension == 3 ? 2 : 4); ++n) {
        const SliceCells cells = subdivide(*slice, n);
        const int corners = num_corners(cells.shape);
        EXPECT_EQ(cells.connectivity.size(), static_cast<std::size_t>(corners * std::pow(n, dimension)));
        double sum = 0;
        for (std::size_t first = 0; first < cells.connectivity.size(); first += corners) {
          Slice cell{cells.shape, corners, {}};
          for (int i = 0; i < corners; ++i) cell.point[i] = cells.points[cells.connectivity[first + i]];
          EXPECT_GT(measure(cell), 0);
          sum += measure(cell);
        }
        // Faces between the parts of a wedge are warped; its simplices then cut them along different diagonals.
        EXPECT_NEAR(sum / measure(*slice), 1, cells.shape == SliceShape::wedge ? 0.05 : 1e-11);
      }
    }
  }
}

TEST(SliceCells, RefuseNoSubdivisionAndFinerTetrahedra) {
  Slice slice{SliceShape::tetrahedron, 4, {}};
  EXPECT_THROW(subdivide(slice, 0), std::invalid_argument);
  EXPECT_THROW(subdivide(slice, 3), std::invalid_argument);
}

TEST(SliceEnergy, OfAUniformStateIsItsDensityTimesTheMeasure) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    const PitchedBox box = box_of(dimension);
    const double velocity = 3, strain = 1e-3;
    const PitchedElements pitched = pitch_elements(box, [&](std::span<const double> event) {
      return std::array{strain * event[0] + velocity * event.back(), 0.0, 0.0};
    });
    const OrthonormalBasis basis(dimension + 1, box.degree);
    const Quadrature rule = simplex_quadrature(dimension, 2 * (box.degree - 1));
    SliceEnergy sum;
    for (const SpacetimeElement& element : pitched.elements) {
      const SliceEnergy energy = slice_energy(basis, rule, element, 0.6 * box.end);
      sum.kinetic += energy.kinetic;
      sum.strain += energy.strain;
    }
    const double modulus = box.material.lambda + 2 * box.material.mu;
    EXPECT_NEAR(sum.kinetic / (0.5 * box.material.density * velocity * velocity * box_measure(box)), 1, 1e-10);
    EXPECT_NEAR(sum.strain / (0.5 * modulus * strain * strain * box_measure(box)), 1, 1e-10);
  }
}

}  // namespace
}  // namespace tentpole
