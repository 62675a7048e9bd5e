#include "host/front/front.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "host/mesh/box_mesh.hpp"
#include "host/mesh/mesh_description.hpp"
#include "tests/host/front/random_meshes.hpp"

namespace tentpole {
namespace {

BoxMesh unstructured_box(int dimension, std::array<int, 3> cells, std::uint64_t seed) {
  BoxMesh box;
  box.dimension = dimension;
  box.cells = cells;
  box.max = {1e-3 * cells[0], 1e-3 * cells[1], 1e-3 * cells[2]};
  box.pattern = MeshPattern::unstructured;
  box.seed = seed;
  return box;
}

/// Wave speeds between 1000 and 6000 m/s, drawn cell by cell.
std::vector<double> mixed_speeds(const SpaceMesh& mesh, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<double> speeds;
  for (int cell = 0; cell < mesh.num_cells(); ++cell)
    speeds.push_back(1000 + 5000 * static_cast<double>(random() >> 40) / double(1 << 24));
  return speeds;
}

double mean_altitude(const SpaceMesh& mesh) {
  double sum = 0;
  for (int vertex = 0; vertex < mesh.num_vertices(); ++vertex) sum += testing::smallest_altitude(mesh, vertex);
  return sum / mesh.num_vertices();
}

struct March {
  std::int64_t num_tents = 0;
  double steepest = 0;     ///< largest |grad tau| c / gamma seen
  double mean_height = 0;  ///< pole height / (gamma smallest altitude / c), before the end time cuts it
};

/// Pitches tents to the end time and looks at every front on the way. `mean_height` wants one wave speed, c / gamma.
March march(Front& front, const SpaceMesh& mesh, double end_time, double speed, int limit = 64) {
  March result;
  std::vector<double> altitude;
  for (int vertex = 0; vertex < mesh.num_vertices(); ++vertex)
    altitude.push_back(testing::smallest_altitude(mesh, vertex));
  for (auto minima = front.next_minima(limit, end_time); !minima.empty(); minima = front.next_minima(limit, end_time))
    for (const int vertex : minima) {
      result.mean_height += (front.pole_top_time(vertex, 1e300) - front.time(vertex)) * speed / altitude[vertex];
      front.raise(vertex, front.pole_top_time(vertex, end_time));
      ++result.num_tents;
      result.steepest = std::max(result.steepest, front.steepness(vertex));
    }
  result.mean_height /= static_cast<double>(result.num_tents);
  return result;
}

void expect_all_at(const Front& front, double end_time) {
  for (const double time : front.times()) ASSERT_EQ(time, end_time);
  EXPECT_EQ(front.minimum_time(), end_time);
}

TEST(Front, StaysCausalAfterEveryTentOnRandomMeshesWithMixedWaveSpeeds) {
  const std::vector<BoxMesh> boxes{unstructured_box(1, {50, 1, 1}, 1), unstructured_box(2, {12, 9, 1}, 2),
                                   unstructured_box(3, {4, 5, 3}, 3)};
  for (const BoxMesh& box : boxes) {
    const SpaceMesh mesh = make_box_mesh(box);
    Front front(mesh, mixed_speeds(mesh, box.seed), 0.95);
    const double end_time = 20 * mean_altitude(mesh) / 3000;
    const March result = march(front, mesh, end_time, 3000 / 0.95);
    EXPECT_LE(result.steepest, 1 + 1e-12) << "D = " << box.dimension;
    EXPECT_GT(result.steepest, 0.5) << "D = " << box.dimension;
    expect_all_at(front, end_time);
  }
}

TEST(Front, PeriodicDomainHasNoEdgeWhereTentsDiffer) {
  BoxMesh box;
  box.dimension = 2;
  box.cells = {6, 6, 1};
  box.periodic = {{"left", "right"}, {"bottom", "top"}};
  const SpaceMesh mesh = make_box_mesh(box);
  Front front(mesh, std::vector<double>(mesh.num_cells(), 1.0), 1.0);
  // On a flat front over a translation invariant mesh every vertex has the same first pole.
  for (int vertex = 0; vertex < mesh.num_vertices(); ++vertex) {
    EXPECT_EQ(front.neighbors(vertex).size(), 6u);
    EXPECT_NEAR(front.pole_top_time(vertex, 10.0), front.pole_top_time(0, 10.0), 1e-15);
  }
  const March result = march(front, mesh, 2.0, 1.0);
  EXPECT_LE(result.steepest, 1 + 1e-12);
  expect_all_at(front, 2.0);
}

TEST(Front, RisesOnALineByTheTravelTimeOfTheShorterCell) {
  MeshDescription line;
  line.source = "line";
  line.dimension = 1;
  line.vertices = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}};
  line.cells = {{0, 1, none, none}, {1, 2, none, none}};
  line.cell_region = {0, 0};
  line.named_facets = {{{0, none, none}, 0}, {{2, none, none}, 0}};
  line.region_names = {"all"};
  line.boundary_names = {"end"};
  const SpaceMesh mesh = build_space_mesh(line);
  Front front(mesh, std::vector<double>{2.0, 8.0}, 0.5);  // g = 1/4 and 1/16: travel times 1/4 and 1/8
  EXPECT_DOUBLE_EQ(front.pole_top_time(0, 100), 0.25);
  EXPECT_DOUBLE_EQ(front.pole_top_time(1, 100), 0.125);
  EXPECT_DOUBLE_EQ(front.pole_top_time(2, 100), 0.125);
  front.set_times(std::vector<double>{0.25, 0, 0.125});
  EXPECT_EQ(front.next_minima(10, 100), (std::vector<int>{1}));
  EXPECT_DOUBLE_EQ(front.pole_top_time(1, 100), 0.25);
}

TEST(Front, RisesOverOneTriangleToTheCausalOrTheEdgeLimit) {
  MeshDescription triangle;
  triangle.source = "triangle";
  triangle.dimension = 2;
  triangle.vertices = {{-std::sqrt(0.75), 0, 0}, {std::sqrt(0.75), 0, 0}, {0, 0.5, 0}};  // 120 degrees at vertex 2
  triangle.cells = {{0, 1, 2, none}};
  triangle.cell_region = {0};
  triangle.named_facets = {{{0, 1, none}, 0}, {{1, 2, none}, 0}, {{0, 2, none}, 0}};
  triangle.region_names = {"all"};
  triangle.boundary_names = {"side"};
  const SpaceMesh mesh = build_space_mesh(triangle);
  Front front(mesh, std::vector<double>{2.0}, 0.5);                             // g = 1/4
  EXPECT_DOUBLE_EQ(front.pole_top_time(2, 100), 0.25 * 0.5);                    // causal: its altitude
  EXPECT_DOUBLE_EQ(front.pole_top_time(0, 100), 0.25 * 0.7 * std::sqrt(0.75));  // edge: 0.7 sin 120
  // Over a base that rises by slope s from vertex 0: tau at the foot plus altitude times sqrt(g^2 - s^2).
  const double slope = 0.03;
  front.set_times(std::vector<double>{0, 2 * std::sqrt(0.75) * slope, 0});
  EXPECT_DOUBLE_EQ(front.pole_top_time(2, 100), std::sqrt(0.75) * slope + 0.5 * std::sqrt(0.25 * 0.25 - slope * slope));
}

TEST(Front, HalvesTheRestWhereLessThanTwoHeightsRemain) {
  const SpaceMesh mesh = make_box_mesh(unstructured_box(2, {4, 4, 1}, 7));
  const Front front(mesh, std::vector<double>(mesh.num_cells(), 3000.0));
  for (int vertex = 0; vertex < mesh.num_vertices(); ++vertex) {
    const double height = front.pole_top_time(vertex, 1.0);
    EXPECT_DOUBLE_EQ(front.pole_top_time(vertex, 2.5 * height), height);
    EXPECT_DOUBLE_EQ(front.pole_top_time(vertex, 1.5 * height), 0.75 * height);
    EXPECT_EQ(front.pole_top_time(vertex, 0.9 * height), 0.9 * height);
  }
}

/// Tops of all poles of each vertex, in their order.
std::vector<std::vector<double>> all_poles(const SpaceMesh& mesh, const std::vector<double>& speeds, double end_time,
                                           int limit, bool reverse) {
  Front front(mesh, speeds);
  std::vector<std::vector<double>> poles(mesh.num_vertices());
  for (auto minima = front.next_minima(limit, end_time); !minima.empty(); minima = front.next_minima(limit, end_time)) {
    if (reverse) std::reverse(minima.begin(), minima.end());
    for (const int vertex : minima) {
      poles[vertex].push_back(front.pole_top_time(vertex, end_time));
      front.raise(vertex, poles[vertex].back());
    }
  }
  return poles;
}

TEST(Front, TentsDoNotDependOnTheSizeOrOrderOfBatches) {
  for (const BoxMesh& box : {unstructured_box(2, {30, 20, 1}, 5), unstructured_box(3, {5, 5, 5}, 5)}) {
    const SpaceMesh mesh = make_box_mesh(box);
    const std::vector<double> speeds = mixed_speeds(mesh, 4);
    const double end_time = 10 * mean_altitude(mesh) / 3000;
    const auto one_by_one = all_poles(mesh, speeds, end_time, 1, false);
    EXPECT_EQ(one_by_one, all_poles(mesh, speeds, end_time, 4096, false));
    EXPECT_EQ(one_by_one, all_poles(mesh, speeds, end_time, 4096, true));
    EXPECT_EQ(one_by_one, all_poles(mesh, speeds, end_time, 7, true));
  }
}

TEST(Front, HandsOutIndependentMinimaWhileOthersAreStillBeingSolved) {
  const SpaceMesh mesh = make_box_mesh(unstructured_box(2, {20, 20, 1}, 6));
  Front front(mesh, std::vector<double>(mesh.num_cells(), 3000.0));
  const double end_time = 1e-5;
  std::vector<int> in_flight = front.next_minima(10, end_time);
  for (int batch = 0; batch < 200; ++batch) {
    const std::vector<int> next = front.next_minima(10, end_time);
    std::vector<char> used(mesh.num_cells(), 0);
    for (const std::vector<int>* group : {&std::as_const(in_flight), &next})
      for (const int vertex : *group) {
        EXPECT_TRUE(front.is_local_minimum(vertex));
        for (const CellCorner& entry : front.star(vertex)) EXPECT_EQ(used[entry.cell]++, 0);
      }
    for (const int vertex : in_flight) front.raise(vertex, front.pole_top_time(vertex, end_time));
    in_flight = next;
  }
}

TEST(Front, GoesOnWithTheSameTentsAfterAPauseARefusalAndARestart) {
  const SpaceMesh mesh = make_box_mesh(unstructured_box(2, {8, 8, 1}, 8));
  const std::vector<double> speeds(mesh.num_cells(), 3000.0);
  Front front(mesh, speeds);
  const double pause = 2e-6, end_time = 4e-6;
  march(front, mesh, pause, 3000 / 0.95);
  expect_all_at(front, pause);
  EXPECT_TRUE(front.next_minima(10, pause).empty());
  const std::vector<int> minima = front.next_minima(3, end_time);
  ASSERT_EQ(minima.size(), 3u);
  for (const int vertex : minima) front.put_back(vertex);
  Front resumed(mesh, speeds);
  resumed.set_times(front.times());
  const March a = march(front, mesh, end_time, 3000 / 0.95), b = march(resumed, mesh, end_time, 3000 / 0.95);
  EXPECT_EQ(a.num_tents, b.num_tents);
  expect_all_at(front, end_time);
  expect_all_at(resumed, end_time);
}

TEST(Front, RefusesWaveSpeedsAndTimesThatMakeNoSense) {
  const SpaceMesh mesh = make_box_mesh(unstructured_box(2, {2, 2, 1}, 1));
  std::vector<double> speeds(mesh.num_cells(), 3000.0);
  EXPECT_THROW(Front(mesh, speeds, 1.5), std::invalid_argument);
  EXPECT_THROW(Front(mesh, std::vector<double>{1.0}), std::invalid_argument);
  Front front(mesh, speeds);
  std::vector<double> times(mesh.num_vertices(), 0.0);
  times[3] = 1.0;
  EXPECT_THROW(front.set_times(times), std::invalid_argument);
  EXPECT_EQ(front.time(3), 0.0);
  speeds[5] = -1;
  EXPECT_THROW(Front(mesh, speeds), std::invalid_argument);
}

TEST(Front, PolesAreAsHighAsTheDesignExpects) {
  const SpaceMesh plane = make_box_mesh(unstructured_box(2, {24, 24, 1}, 9));
  const SpaceMesh box = make_box_mesh(unstructured_box(3, {7, 7, 7}, 9));
  for (const SpaceMesh* mesh : {&plane, &box}) {
    Front front(*mesh, std::vector<double>(mesh->num_cells(), 3000.0));
    const March result = march(front, *mesh, 30 * mean_altitude(*mesh) / 3000, 3000 / 0.95);
    std::printf("  D = %d: mean height %.3f altitudes / c\n", mesh->dimension, result.mean_height);
    EXPECT_GT(result.mean_height, mesh->dimension == 2 ? 1.0 : 0.85);
    EXPECT_LE(result.steepest, 1 + 1e-12);
  }
}

}  // namespace
}  // namespace tentpole
