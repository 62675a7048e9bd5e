#include "host/mesh/box_mesh.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "host/mesh/mesh_error.hpp"
#include "host/mesh/simplex_geometry.hpp"
#include "tests/host/mesh/mesh_angles.hpp"

namespace tentpole {
namespace {

const std::array<std::string, 6> side_names{"left", "right", "bottom", "top", "back", "front"};
const PeriodicPairs all_sides{{"left", "right"}, {"bottom", "top"}, {"back", "front"}};

BoxMesh sample_box(int dimension, MeshPattern pattern, bool periodic) {
  BoxMesh box;
  box.dimension = dimension;
  box.min = {-1e-3, 2e-3, 0.5e-3};
  box.max = {5e-3, 6e-3, 5.5e-3};
  box.cells = {6, 4, 5};
  box.pattern = pattern;
  box.seed = 12345;
  if (periodic) box.periodic.assign(all_sides.begin(), all_sides.begin() + dimension);
  return box;
}

std::vector<BoxMesh> all_samples() {
  std::vector<BoxMesh> samples;
  for (int dimension = 1; dimension <= 3; ++dimension)
    for (const MeshPattern pattern : {MeshPattern::structured, MeshPattern::unstructured})
      for (const bool periodic : {false, true}) samples.push_back(sample_box(dimension, pattern, periodic));
  return samples;
}

double box_measure(const BoxMesh& box) {
  double measure = 1;
  for (int axis = 0; axis < box.dimension; ++axis) measure *= box.max[axis] - box.min[axis];
  return measure;
}

/// FNV-1a over the bits of all coordinates and corners.
std::uint64_t fingerprint(const SpaceMesh& mesh) {
  std::uint64_t hash = 14695981039346656037u;
  const auto mix = [&](std::uint64_t value) { hash = (hash ^ value) * 1099511628211u; };
  for (const Point& vertex : mesh.vertices)
    for (const double coordinate : vertex) mix(std::bit_cast<std::uint64_t>(coordinate));
  for (const auto& cell : mesh.cells)
    for (const std::int32_t corner : cell) mix(static_cast<std::uint64_t>(corner));
  return hash;
}

TEST(BoxMesh, FillsTheBoxWithPositiveCellsOfAscendingCorners) {
  for (const BoxMesh& box : all_samples()) {
    const SpaceMesh mesh = make_box_mesh(box);
    double measure = 0;
    for (int cell = 0; cell < mesh.num_cells(); ++cell) {
      EXPECT_GT(mesh.cell_measure(cell), 0);
      measure += mesh.cell_measure(cell);
      for (int i = 0; i < mesh.dimension; ++i) EXPECT_LT(mesh.cells[cell][i], mesh.cells[cell][i + 1]);
    }
    EXPECT_NEAR(measure / box_measure(box), 1, 1e-13);
    const double mean = std::pow(box_measure(box) / mesh.num_cells(), 1.0 / box.dimension);
    EXPECT_NEAR(mesh.mean_cell_size() / mean, 1, 1e-13);
  }
}

TEST(BoxMesh, HasTheCountsOfItsPattern) {
  for (const BoxMesh& box : all_samples()) {
    const SpaceMesh mesh = make_box_mesh(box);
    int num_boxes = 1, num_vertices = 1, simplices = 1;
    for (int axis = 0; axis < box.dimension; ++axis) {
      num_boxes *= box.cells[axis];
      num_vertices *= box.cells[axis] + (box.periodic.empty() ? 1 : 0);
      simplices *= axis + 1;
    }
    EXPECT_EQ(mesh.num_cells(), num_boxes * simplices);
    EXPECT_EQ(mesh.num_vertices(), num_vertices);
    EXPECT_EQ(mesh.region_names, std::vector<std::string>{"all"});
  }
}

TEST(BoxMesh, NeighborsAgreeOnTheFacetBetweenThem) {
  for (const BoxMesh& box : all_samples()) {
    const SpaceMesh mesh = make_box_mesh(box);
    for (int cell = 0; cell < mesh.num_cells(); ++cell)
      for (int facet = 0; facet <= mesh.dimension; ++facet) {
        const std::int32_t other = mesh.neighbor[cell][facet];
        EXPECT_EQ(other == none, mesh.facet_boundary[cell][facet] != none);
        if (other == none) continue;
        const int other_facet = mesh.neighbor_facet[cell][facet];
        EXPECT_EQ(mesh.neighbor[other][other_facet], cell);
        EXPECT_EQ(mesh.neighbor_facet[other][other_facet], facet);
        Point translation{};
        for (int i = 0; i < mesh.dimension; ++i) {
          const int own = i + (i >= facet), its = i + (i >= other_facet);
          EXPECT_EQ(mesh.cells[cell][own], mesh.cells[other][its]);
          const Point gap = difference(mesh.corner_position(cell, own), mesh.corner_position(other, its));
          if (i == 0) translation = gap;
          EXPECT_LT(distance(gap, translation), 1e-17);
        }
        if (box.periodic.empty()) {
          EXPECT_EQ(distance(translation, Point{}), 0);
        }
      }
  }
}

TEST(BoxMesh, NamesEverySideAndNothingElse) {
  for (const BoxMesh& box : all_samples()) {
    const SpaceMesh mesh = make_box_mesh(box);
    std::map<std::string, double> measure;
    for (int cell = 0; cell < mesh.num_cells(); ++cell)
      for (int facet = 0; facet <= mesh.dimension; ++facet) {
        if (mesh.facet_boundary[cell][facet] == none) continue;
        const std::string& name = mesh.boundary_names[mesh.facet_boundary[cell][facet]];
        const auto side = std::find(side_names.begin(), side_names.end(), name) - side_names.begin();
        const int axis = static_cast<int>(side) / 2;
        const double wall = side % 2 == 0 ? box.min[axis] : box.max[axis];
        Point previous{};
        for (int i = 0, n = 0; i <= mesh.dimension; ++i) {
          if (i == facet) continue;
          EXPECT_EQ(mesh.corner_position(cell, i)[axis], wall) << name;
          if (n++ > 0 && mesh.dimension == 2) measure[name] += distance(previous, mesh.corner_position(cell, i));
          previous = mesh.corner_position(cell, i);
        }
      }
    EXPECT_EQ(mesh.boundary_names.size(), box.periodic.empty() ? 2u * box.dimension : 0u);
    if (mesh.dimension == 2 && box.periodic.empty()) {
      EXPECT_NEAR(measure["left"], 4e-3, 1e-15);
      EXPECT_NEAR(measure["top"], 6e-3, 1e-15);
    }
  }
}

TEST(BoxMesh, StarsListEveryCornerOnce) {
  for (const BoxMesh& box : all_samples()) {
    const SpaceMesh mesh = make_box_mesh(box);
    int num_entries = 0;
    for (int vertex = 0; vertex < mesh.num_vertices(); ++vertex)
      for (const CellCorner& entry : mesh.star(vertex)) {
        EXPECT_EQ(mesh.cells[entry.cell][entry.corner], vertex);
        ++num_entries;
      }
    EXPECT_EQ(num_entries, mesh.num_cells() * (mesh.dimension + 1));
  }
}

TEST(BoxMesh, UnstructuredTrianglesKeepTheirAnglesAbove20Degrees) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    BoxMesh box;
    box.cells = {25, 17, 1};
    box.max = {25, 17, 1};
    box.pattern = MeshPattern::unstructured;
    box.seed = seed;
    const testing::AngleRange range = testing::angle_range(make_box_mesh(box));
    EXPECT_GT(range.smallest, 20) << "seed " << seed;
    EXPECT_LT(range.largest, 125) << "seed " << seed;
  }
}

TEST(BoxMesh, UnstructuredTetrahedraKeepTheirDihedralAnglesBetween15And150Degrees) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    BoxMesh box;
    box.dimension = 3;
    box.cells = {6, 6, 6};
    box.pattern = MeshPattern::unstructured;
    box.seed = seed;
    const testing::AngleRange range = testing::angle_range(make_box_mesh(box));
    EXPECT_GT(range.smallest, 15) << "seed " << seed;
    EXPECT_LT(range.largest, 150) << "seed " << seed;
  }
}

TEST(BoxMesh, IsTheSameBitsOnEveryMachineAndAnotherMeshForAnotherSeed) {
  const std::array<std::uint64_t, 4> known{0, 14570046068152987930u, 8420373881496913940u, 117014518053814699u};
  for (int dimension = 1; dimension <= 3; ++dimension) {
    BoxMesh box = sample_box(dimension, MeshPattern::unstructured, false);
    EXPECT_EQ(fingerprint(make_box_mesh(box)), known[dimension]) << "D = " << dimension;
    box.seed += 1;
    EXPECT_NE(fingerprint(make_box_mesh(box)), known[dimension]);
  }
}

TEST(BoxMesh, StructuredDiagonalsLeanBothWaysAndInnerVerticesHaveSixCells) {
  const SpaceMesh mesh = make_box_mesh(sample_box(2, MeshPattern::structured, true));
  for (int vertex = 0; vertex < mesh.num_vertices(); ++vertex) EXPECT_EQ(mesh.star(vertex).size(), 6u);
  int rising = 0, falling = 0;
  for (int cell = 0; cell < mesh.num_cells(); ++cell)
    for (int i = 0; i < 3; ++i) {
      const Point edge = difference(mesh.corner_position(cell, (i + 1) % 3), mesh.corner_position(cell, i));
      rising += edge[0] * edge[1] > 1e-9;
      falling += edge[0] * edge[1] < -1e-9;
    }
  EXPECT_EQ(rising, falling);
  EXPECT_GT(rising, 0);
}

TEST(BoxMesh, ScalesAllLengthsTogether) {
  SpaceMesh mesh = make_box_mesh(sample_box(2, MeshPattern::unstructured, true));
  mesh.scale_lengths(1 / mesh.mean_cell_size());
  EXPECT_NEAR(mesh.mean_cell_size(), 1, 1e-14);
}

std::string refusal(const BoxMesh& box) {
  try {
    make_box_mesh(box);
  } catch (const MeshError& error) {
    return error.what();
  }
  return "accepted";
}

struct SpoiledBox {
  int dimension;
  std::array<double, 3> min, max;
  std::array<int, 3> cells;
  std::string advice;
};

TEST(BoxMesh, AdviceForBoxesThatRoundingSpoilsIsAboutTheBox) {
  const std::string far = "m apart. Move the box of [domain] nearer to the origin, or give fewer cells.";
  const std::string thin = "but its longest side is 1 m. Give [domain] sides and numbers of cells";
  const SpoiledBox boxes[] = {
      {2, {1e9, 1e9, 0}, {1e9 + 2e-7, 1e9 + 2e-7, 0}, {4, 4, 1}, far},
      {1, {1e15, 0, 0}, {1e15 + 10, 0, 0}, {100, 1, 1}, "0.1 m wide in x, but coordinates of 1e+15 m are 0.125 " + far},
      {2, {0, 0, 0}, {1, 1e-10, 0}, {4, 1, 1}, "1e-10 m wide in y, " + thin},
      {3, {0, 0, 0}, {1, 1, 1e-9}, {1, 1, 2}, "5e-10 m wide in z, " + thin}};
  for (const SpoiledBox& spoiled : boxes) {
    BoxMesh box;
    box.dimension = spoiled.dimension;
    box.min = spoiled.min;
    box.max = spoiled.max;
    box.cells = spoiled.cells;
    const std::string message = refusal(box);
    EXPECT_NE(message.find(spoiled.advice), std::string::npos) << message;
    EXPECT_EQ(message.find("Gmsh"), std::string::npos) << message;
  }
}

TEST(BoxMesh, PeriodicSidesMeetFarFromTheOrigin) {
  // Numbers of this size lie 1.2e-10 m apart, farther than 1e-9 of the sides.
  BoxMesh box;
  box.min = {1e6, 1e6, 0};
  box.max = {1e6 + 0.03, 1e6 + 0.03, 0};
  box.cells = {7, 7, 1};
  box.periodic = {{"left", "right"}, {"bottom", "top"}};
  const SpaceMesh mesh = make_box_mesh(box);
  EXPECT_EQ(mesh.num_vertices(), 49);
  EXPECT_EQ(mesh.shifts.size(), 4u);
}

TEST(BoxMesh, LengthsBeyondDoublePrecisionAreRefused) {
  const std::string bounds = "coordinates may be at most 1e100 m, and cells at least 1e-100 m";
  for (const auto& [min, max] : {std::pair{-1e308, 1e308}, {0.0, 1e200}, {0.0, 1e-200}, {5e-324, 1e-323}}) {
    BoxMesh box;
    box.dimension = 1;
    box.cells = {2, 1, 1};
    box.min = {min, 0, 0};
    box.max = {max, 0, 0};
    const std::string message = refusal(box);
    EXPECT_NE(message.find(bounds), std::string::npos) << message;
  }
}

TEST(BoxMesh, RefusesSizesThatMakeNoMesh) {
  BoxMesh box;
  box.cells = {3, 0, 1};
  EXPECT_THROW(make_box_mesh(box), MeshError);
  box.cells = {3, 3, 1};
  box.max = {1, -1, 1};
  EXPECT_THROW(make_box_mesh(box), MeshError);
  box.max = {1, 1, 1};
  box.cells = {1, 3, 1};
  box.periodic = {{"left", "right"}};
  EXPECT_THROW(make_box_mesh(box), MeshError);  // a cell would meet itself
  box.cells = {3, 3, 1};
  box.periodic = {{"left", "top"}};
  EXPECT_THROW(make_box_mesh(box), MeshError);
  box.periodic = {{"left", "right"}, {"left", "right"}};
  EXPECT_THROW(make_box_mesh(box), MeshError);
}

}  // namespace
}  // namespace tentpole
