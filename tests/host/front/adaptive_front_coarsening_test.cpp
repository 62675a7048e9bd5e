#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "host/front/adaptive_front.hpp"
#include "host/front/polygon_triangulation.hpp"
#include "host/mesh/box_mesh.hpp"
#include "host/mesh/mesh_description.hpp"
#include "tests/host/front/polygon_mesh.hpp"
#include "tests/host/front/random_meshes.hpp"
#include "tests/host/front/random_operations.hpp"

namespace tentpole {
namespace {

constexpr double no_end = 1e300;
const std::vector<double> unit_speed{1.0};

SpaceMesh make_box(int dimension, int n) {
  BoxMesh box;
  box.dimension = dimension;
  box.cells = {n, n, 1};
  return make_box_mesh(box);
}

/// Ordinary tents until a vertex is a local minimum that lies below all its neighbours.
void raise_neighbors(AdaptiveFront& front, int vertex) {
  for (int round = 0; round < 100; ++round) {
    const auto neighbors = front.mesh().neighbors(vertex);
    const bool is_strict = std::all_of(neighbors.begin(), neighbors.end(),
                                       [&](int other) { return front.time(other) > front.time(vertex); });
    if (is_strict) return;
    for (const int minimum : front.local_minima(no_end)) front.raise(minimum, front.pole_top_time(minimum, no_end));
  }
  FAIL() << "vertex " << vertex << " never became a strict minimum";
}

TEST(AdaptiveFrontCoarsening, BestTriangulationIsTheBestOfAll) {
  // A pentagon whose triangles cost their smallest corner plus one, except that a triangle on (0, 2) is forbidden.
  const auto triangles = best_triangulation(5, [](const PolygonTriangle& t) {
    const bool is_forbidden = (t[0] == 0 && t[1] == 2) || (t[0] == 0 && t[2] == 2);
    return is_forbidden ? 1.0 / 0.0 : 1.0 + t[0];
  });
  ASSERT_EQ(triangles.size(), 3u);
  // Triangulations without the diagonal (0, 2): fans from 1 and 3 cost 2; 4 forces (0, 1, 4) with (1, 2, 4): cost 3.
  double worst = 0;
  for (const PolygonTriangle& t : triangles) worst = std::max(worst, 1.0 + t[0]);
  EXPECT_EQ(worst, 2);
  EXPECT_TRUE(best_triangulation(4, [](const PolygonTriangle&) { return 1.0 / 0.0; }).empty());
}

TEST(AdaptiveFrontCoarsening, TakesTheCentreOutOfAPentagon) {
  AdaptiveFront front(testing::polygon_mesh(5), unit_speed);
  EXPECT_FALSE(front.plan_deletion(5));  // flat: the cone has no volume
  raise_neighbors(front, 5);
  const auto plan = front.plan_deletion(5);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->below.size(), 5u);
  EXPECT_EQ(plan->above.size(), 3u);
  ASSERT_EQ(plan->between.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(plan->between[i].vertex[3], 5) << "the cone over cell " << i;
  const std::vector<std::int32_t> ids = front.commit(*plan);
  ASSERT_EQ(ids.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(front.mesh().cell(ids[i]).vertex, plan->above[i].vertex);
  EXPECT_FALSE(front.mesh().is_alive_vertex(5));
  EXPECT_EQ(front.mesh().num_cells(), 3);
  EXPECT_NO_THROW(front.check());
  EXPECT_FALSE(front.is_unchanged(plan->below));
  EXPECT_THROW(front.commit(*plan), std::logic_error);
}

TEST(AdaptiveFrontCoarsening, ObeysTheLimitsOfAngleAndSize) {
  AdaptiveFront front(testing::polygon_mesh(5), unit_speed);
  raise_neighbors(front, 5);
  EXPECT_FALSE(front.plan_deletion(5, {.smallest_angle = 15, .longest_edge = 1.5}));  // diagonals are 1.9 long
  EXPECT_TRUE(front.plan_deletion(5, {.smallest_angle = 35}));
  EXPECT_FALSE(front.plan_deletion(5, {.smallest_angle = 37}));  // a fan of a regular pentagon has 36 degrees
}

TEST(AdaptiveFrontCoarsening, UndoesRefinementAlongSidesAndInterfaces) {
  SpaceMesh mesh = make_box(2, 4);
  testing::divide_into_regions(mesh, 0.5);
  AdaptiveFront front(mesh, std::vector<double>{1.0, 1.0});
  const FrontMesh& cells = front.mesh();
  std::mt19937_64 random(1);
  for (int i = 0; i < 100; ++i) front.try_split(testing::draw_cell(cells, random));
  int on_side = 0, on_interface = 0, inside = 0;
  for (int round = 0; round < 400; ++round)
    for (const int vertex : front.local_minima(no_end)) {
      const auto plan = front.plan_deletion(vertex);
      if (!plan) {
        front.raise(vertex, front.pole_top_time(vertex, no_end));
        continue;
      }
      const bool is_line = cells.kind(vertex) == VertexKind::line;
      inside += !is_line;
      on_side += is_line && !plan->boundary.empty();
      on_interface += is_line && plan->boundary.empty();
      EXPECT_NE(cells.kind(vertex), VertexKind::corner);
      front.commit(*plan);
      ASSERT_NO_THROW(front.check());
    }
  EXPECT_GT(inside, 20);
  EXPECT_GT(on_side, 4);
  EXPECT_GT(on_interface, 2);
  std::vector<double> areas(2, 0.0);
  for (int cell = 0; cell < cells.num_cell_slots(); ++cell)
    if (cells.is_alive_cell(cell)) areas[cells.cell(cell).region] += std::abs(signed_measure(cells.simplex(cell)));
  EXPECT_NEAR(areas[0], 0.5, 1e-14);
  EXPECT_NEAR(areas[1], 0.5, 1e-14);
}

TEST(AdaptiveFrontCoarsening, MergesIntervalsOfALine) {
  AdaptiveFront front(make_box(1, 4), unit_speed);
  raise_neighbors(front, 2);
  const auto plan = front.plan_deletion(2);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->above.size(), 1u);
  EXPECT_EQ(plan->above[0].vertex, (FrontVertices{1, 3, none}));
  front.commit(*plan);
  EXPECT_EQ(front.mesh().num_cells(), 3);
  EXPECT_NO_THROW(front.check());
  EXPECT_FALSE(front.plan_deletion(0));
  AdaptiveFront cracked(make_box(1, 4), unit_speed);
  cracked.mark_crack(2, 2);
  raise_neighbors(cracked, 2);
  EXPECT_FALSE(cracked.plan_deletion(2));
}

TEST(AdaptiveFrontCoarsening, FlipsAnEdgeOnlyForBetterAnglesAndALaterDiagonal) {
  MeshDescription kite;
  kite.source = "kite";
  kite.dimension = 2;
  kite.vertices = {{-1, 0, 0}, {1, 0, 0}, {0, 0.4, 0}, {0, -0.4, 0}};
  kite.cells = {{0, 1, 2, none}, {0, 1, 3, none}};
  kite.cell_region = {0, 0};
  kite.named_facets = {{{0, 2, none}, 0}, {{1, 2, none}, 0}, {{0, 3, none}, 0}, {{1, 3, none}, 0}};
  kite.region_names = {"all"};
  kite.boundary_names = {"side"};
  AdaptiveFront front(build_space_mesh(kite), unit_speed);
  EXPECT_FALSE(front.plan_flip(0, 1));  // flat: no volume
  std::optional<FlipPlan> plan;
  for (int round = 0; round < 50 && !plan; ++round) {
    const int vertex = front.local_minima(no_end).front();
    front.raise(vertex, front.pole_top_time(vertex, no_end));
    plan = front.plan_flip(1, 0);
    if (!plan) continue;
    // The diagonal is later than the edge where they cross.
    EXPECT_GT(front.time(2) + front.time(3), front.time(0) + front.time(1));
  }
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->diagonal, (std::array<std::int32_t, 2>{2, 3}));
  EXPECT_GT(plan->angle_gain, 0);
  ASSERT_EQ(plan->exchange.between.size(), 1u);
  EXPECT_EQ(plan->exchange.between[0].vertex, (std::array<std::int32_t, 4>{0, 1, 2, 3}));
  AdaptiveFront cracked = front;
  cracked.mark_crack(0, 1);
  EXPECT_FALSE(cracked.plan_flip(0, 1));
  const auto ids = front.commit(plan->exchange);
  EXPECT_EQ(front.mesh().cell(ids[0]).vertex, (FrontVertices{0, 2, 3}));
  EXPECT_EQ(front.mesh().cell(ids[1]).vertex, (FrontVertices{1, 2, 3}));
  EXPECT_NO_THROW(front.check());
  EXPECT_FALSE(front.plan_flip(2, 3));  // back would make the angles worse
}

TEST(AdaptiveFrontCoarsening, CracksAndCornersSurviveRandomOperations) {
  SpaceMesh mesh = testing::bad_triangle_mesh(6, 8, 10, 140);
  testing::divide_into_regions(mesh, 0.5);
  AdaptiveFront front(mesh, std::vector<double>{1.0, 1.3});
  std::mt19937_64 random(6);
  testing::mark_random_cracks(front, random, 6);
  struct Kept {
    int vertex;
    Point position;
  };
  std::vector<Kept> kept;
  const auto length_of_cracks = [&] {
    double length = 0;
    for (int index = 0; index < front.cracks().size(); ++index) {
      if (front.cracks().is_retired(index)) continue;
      const auto [a, b] = front.cracks().edge(index);
      length += std::hypot(front.mesh().position(a)[0] - front.mesh().position(b)[0],
                           front.mesh().position(a)[1] - front.mesh().position(b)[1]);
    }
    return length;
  };
  const double crack_length = length_of_cracks();
  ASSERT_GT(crack_length, 1);
  for (int vertex = 0; vertex < front.mesh().num_vertex_slots(); ++vertex)
    if (front.mesh().kind(vertex) == VertexKind::corner || !front.cracks().at(vertex).empty())
      kept.push_back({vertex, front.mesh().position(vertex)});
  testing::OperationCounts counts;
  for (int i = 0; i < 20000; ++i) testing::random_operation(front, random, 0.95, {}, counts);
  EXPECT_GT(counts.deletions, 500);
  EXPECT_GT(counts.flips, 10);
  for (const Kept& entry : kept) {
    ASSERT_TRUE(front.mesh().is_alive_vertex(entry.vertex));
    EXPECT_EQ(front.mesh().position(entry.vertex), entry.position);
  }
  EXPECT_NEAR(length_of_cracks(), crack_length, 1e-12 * crack_length);
  EXPECT_NO_THROW(front.check());
}

}  // namespace
}  // namespace tentpole
