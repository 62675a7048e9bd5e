#include "host/front/adaptive_front.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/front/front.hpp"
#include "host/front/point_location.hpp"
#include "host/mesh/box_mesh.hpp"
#include "tests/host/front/polygon_mesh.hpp"
#include "tests/host/front/random_meshes.hpp"
#include "tests/host/front/random_operations.hpp"

namespace tentpole {
namespace {

constexpr double no_end = 1e300;

SpaceMesh make_box(int dimension, int n, MeshPattern pattern = MeshPattern::structured) {
  BoxMesh box;
  box.dimension = dimension;
  box.cells = {n, n, 1};
  box.pattern = pattern;
  return make_box_mesh(box);
}

AdaptiveFrontRules full_pitch() {
  AdaptiveFrontRules rules;
  rules.pitch_factor = 1;
  return rules;
}

/// The vertex nearest to a position.
int vertex_at(const FrontMesh& mesh, double x, double y) {
  int nearest = 0;
  const auto distance_to = [&](int vertex) {
    return std::hypot(mesh.position(vertex)[0] - x, mesh.position(vertex)[1] - y);
  };
  for (int vertex = 1; vertex < mesh.num_vertex_slots(); ++vertex)
    if (distance_to(vertex) < distance_to(nearest)) nearest = vertex;
  return nearest;
}

/// Tents on both fronts round by round; every minimum and every pole must agree.
void expect_same_march(const SpaceMesh& mesh, double end_time) {
  Front fixed(mesh, std::vector<double>(mesh.num_cells(), 2.0));
  AdaptiveFront adaptive(mesh, std::vector<double>{2.0}, full_pitch());
  for (auto minima = adaptive.local_minima(end_time); !minima.empty(); minima = adaptive.local_minima(end_time)) {
    ASSERT_EQ(minima, fixed.next_minima(1 << 30, end_time));
    for (const int vertex : minima) {
      const double top = adaptive.pole_top_time(vertex, end_time);
      ASSERT_NEAR(top, fixed.pole_top_time(vertex, end_time), 1e-14);
      fixed.raise(vertex, top);
      adaptive.raise(vertex, top);
    }
  }
  EXPECT_EQ(adaptive.minimum_time(), end_time);
}

TEST(AdaptiveFront, WithFullPitchMeshesTheTentsOfTheFixedFront) {
  expect_same_march(make_box(1, 30, MeshPattern::unstructured), 0.5);
  expect_same_march(make_box(2, 12, MeshPattern::unstructured), 0.5);
  expect_same_march(testing::bad_triangle_mesh(3, 8, 5, 150), 0.2);
}

TEST(AdaptiveFront, PitchesFlatFrontsWithThePitchFactorUnlessThePoleBecomesTooLow) {
  const SpaceMesh mesh = make_box(2, 4);
  AdaptiveFrontRules rules = full_pitch();
  const AdaptiveFront full(mesh, std::vector<double>{1.0}, rules);
  rules.pitch_factor = 0.65;
  const AdaptiveFront gentle(mesh, std::vector<double>{1.0}, rules);
  rules.pitch_factor = 0.1;  // a tenth of an altitude: less than 0.2
  const AdaptiveFront too_gentle(mesh, std::vector<double>{1.0}, rules);
  for (const int vertex : full.local_minima(1)) {
    EXPECT_DOUBLE_EQ(gentle.pole_top_time(vertex, no_end), 0.65 * full.pole_top_time(vertex, no_end));
    EXPECT_EQ(gentle.pole_top_time(vertex, no_end, Pitch::full), full.pole_top_time(vertex, no_end));
    EXPECT_EQ(too_gentle.pole_top_time(vertex, no_end), full.pole_top_time(vertex, no_end));
  }
}

TEST(AdaptiveFront, KnowsWhichVerticesLieOnStraightLinesAndWhichAreCorners) {
  SpaceMesh mesh = make_box(2, 4);
  testing::divide_into_regions(mesh, 0.5);
  const AdaptiveFront front(mesh, std::vector<double>{1.0, 1.0});
  const FrontMesh& cells = front.mesh();
  EXPECT_EQ(cells.kind(vertex_at(cells, 0.25, 0.25)), VertexKind::interior);
  EXPECT_EQ(cells.kind(vertex_at(cells, 0.5, 0.25)), VertexKind::line);
  EXPECT_EQ(cells.kind(vertex_at(cells, 0.25, 0)), VertexKind::line);
  EXPECT_EQ(cells.kind(vertex_at(cells, 0.5, 0)), VertexKind::corner);  // the interface meets the boundary
  EXPECT_EQ(cells.kind(vertex_at(cells, 1, 1)), VertexKind::corner);
  const std::array<std::int32_t, 2> ends{vertex_at(cells, 0.5, 0.25), vertex_at(cells, 0.5, 0.75)};
  EXPECT_EQ(line_neighbors(cells, vertex_at(cells, 0.5, 0.5)), ends);
  const std::vector<double> sides = cells.boundary_measures();
  EXPECT_EQ(sides, (std::vector<double>{1, 1, 1, 1}));
}

TEST(AdaptiveFront, SmoothsADisplacedVertexHalfWayBackToTheMiddle) {
  const AdaptiveFront displaced(testing::polygon_mesh(6, {0.3, 0.2, 0}), std::vector<double>{1.0});
  const auto target = displaced.smoothing_target(6);
  ASSERT_TRUE(target);
  EXPECT_NEAR((*target)[0], 0.15, 1e-15);
  EXPECT_NEAR((*target)[1], 0.1, 1e-15);
  EXPECT_FALSE(displaced.smoothing_target(0));  // a corner
  const AdaptiveFront perfect(testing::polygon_mesh(6), std::vector<double>{1.0});
  EXPECT_FALSE(perfect.smoothing_target(6));
  SpaceMesh line = make_box(1, 4);
  line.vertices[2][0] = 0.6;
  const AdaptiveFront uneven(line, std::vector<double>{1.0});
  EXPECT_DOUBLE_EQ((*uneven.smoothing_target(2))[0], 0.55);
}

TEST(AdaptiveFront, InclinedPolesStayOnTheirLineAndSlowerThanWaves) {
  SpaceMesh mesh = make_box(2, 6);
  testing::divide_into_regions(mesh, 0.5);
  const std::vector<double> speeds{1.0, 2.0};
  AdaptiveFront front(mesh, speeds);
  int num_inclined = 0, num_on_lines = 0;
  for (int round = 0; round < 20; ++round)
    for (const int vertex : front.local_minima(no_end)) {
      const Point start = front.mesh().position(vertex);
      const double bottom = front.time(vertex);
      const auto tent = front.plan_inclined_tent(vertex, {0.3, 0.3, 0}, no_end);
      if (!tent) {
        front.raise(vertex, front.pole_top_time(vertex, no_end));
        continue;
      }
      const double dx = tent->position[0] - start[0], dy = tent->position[1] - start[1];
      EXPECT_LE(std::hypot(dx, dy), 0.5 * 2.0 * (tent->time - bottom) * (1 + 1e-12));
      EXPECT_NE(front.mesh().kind(vertex), VertexKind::corner);
      if (front.mesh().kind(vertex) == VertexKind::line) {
        ++num_on_lines;
        EXPECT_TRUE(dx == 0 || dy == 0);
      }
      ++num_inclined;
      front.raise_inclined(vertex, *tent);
      ASSERT_NO_THROW(front.check());
    }
  EXPECT_GT(num_inclined, 50);
  EXPECT_GT(num_on_lines, 5);
}

TEST(AdaptiveFront, FindsTheCellOfAPointFromAnywhere) {
  std::mt19937_64 random(5);
  for (const SpaceMesh& mesh : {make_box(1, 20, MeshPattern::unstructured), testing::bad_triangle_mesh(2, 8, 2, 170)}) {
    AdaptiveFront front(mesh, std::vector<double>{1.0});
    for (int split = 0; split < 100; ++split) front.try_split(testing::draw_cell(front.mesh(), random));
    for (int trial = 0; trial < 300; ++trial) {
      const int cell = testing::draw_cell(front.mesh(), random), start = testing::draw_cell(front.mesh(), random);
      Point centre{};
      const FrontSimplex simplex = front.mesh().simplex(cell);
      for (int corner = 0; corner <= mesh.dimension; ++corner)
        for (int axis = 0; axis < mesh.dimension; ++axis)
          centre[axis] += simplex.position[corner][axis] / (mesh.dimension + 1);
      EXPECT_EQ(locate(front.mesh(), centre, start), cell);
      EXPECT_EQ(locate(front.mesh(), centre), cell);
    }
    EXPECT_EQ(locate(front.mesh(), {1.5, 0.5, 0}), none);
  }
}

std::string bytes_of(const AdaptiveFront& front) {
  std::ostringstream stream;
  front.save(stream);
  return stream.str();
}

AdaptiveFront worn_front(const SpaceMesh& mesh, int num_operations, std::mt19937_64& random) {
  AdaptiveFront front(mesh, std::vector<double>{1.0});
  testing::mark_random_cracks(front, random, 20);
  testing::OperationCounts counts;
  for (int i = 0; i < num_operations; ++i) testing::random_operation(front, random, 0.95, {}, counts);
  return front;
}

TEST(AdaptiveFront, GoesOnBitwiseTheSameAfterACheckpointAndFromTheSameSeed) {
  for (const SpaceMesh& mesh : {make_box(1, 20, MeshPattern::unstructured), testing::bad_triangle_mesh(4, 6, 5, 150)}) {
    std::mt19937_64 random(7), random_again(7);
    AdaptiveFront front = worn_front(mesh, 1500, random);
    EXPECT_TRUE(bytes_of(front) == bytes_of(worn_front(mesh, 1500, random_again)));
    std::istringstream stream(bytes_of(front));
    AdaptiveFront resumed(mesh, std::vector<double>{1.0});
    resumed.load(stream);
    EXPECT_TRUE(bytes_of(front) == bytes_of(resumed));
    // Which minimum the random operations take depends on the lists, so these must agree too.
    testing::OperationCounts counts, counts_resumed;
    for (int i = 0; i < 1500; ++i) {
      testing::random_operation(front, random, 0.95, {}, counts);
      testing::random_operation(resumed, random_again, 0.95, {}, counts_resumed);
    }
    EXPECT_TRUE(bytes_of(front) == bytes_of(resumed));
    EXPECT_EQ(counts.tents, counts_resumed.tents);
  }
}

TEST(AdaptiveFront, RefusesDamagedCheckpoints) {
  const SpaceMesh mesh = testing::bad_triangle_mesh(4, 4, 5, 150);
  std::mt19937_64 random(7);
  const AdaptiveFront front = worn_front(mesh, 300, random);
  const std::string whole = bytes_of(front);
  AdaptiveFront target(mesh, std::vector<double>{1.0});
  const std::string before = bytes_of(target);
  for (const std::size_t length : {std::size_t(0), whole.size() / 3, whole.size() - 1}) {
    std::istringstream stream(whole.substr(0, length));
    EXPECT_THROW(target.load(stream), std::runtime_error);
  }
  const std::size_t coordinate = 4 + 8 + 24 * 30, sign_and_exponent = coordinate + 7;
  ASSERT_TRUE(front.mesh().is_alive_vertex(30));
  std::string changed = whole;
  changed[sign_and_exponent] ^= 0x40;
  std::istringstream stream(changed);
  EXPECT_THROW(target.load(stream), std::runtime_error);
  EXPECT_TRUE(bytes_of(target) == before);
}

TEST(AdaptiveFront, RefusesCheckpointsWhoseCellsHaveIndicesThatLeadNowhere) {
  const SpaceMesh mesh = testing::bad_triangle_mesh(4, 4, 5, 150);
  std::mt19937_64 random(7);
  const AdaptiveFront front = worn_front(mesh, 300, random);
  const std::string whole = bytes_of(front);
  const std::size_t num_vertices = front.mesh().num_vertex_slots(),
                    num_free = num_vertices - front.mesh().num_vertices(), length = sizeof(std::int64_t);
  const std::size_t first_cell = sizeof(std::int32_t) + (length + sizeof(Point) * num_vertices) +
                                 (length + sizeof(double) * num_vertices) + (length + num_vertices) +
                                 (length + sizeof(std::int32_t) * num_free) + length;
  int cell = 0;
  while (!front.mesh().is_alive_cell(cell)) ++cell;
  for (const std::size_t member :
       {offsetof(FrontCell, vertex), offsetof(FrontCell, neighbor), offsetof(FrontCell, boundary)})
    for (const std::int32_t index : {2000000000, -7}) {
      std::string changed = whole;
      std::memcpy(&changed[first_cell + cell * sizeof(FrontCell) + member], &index, sizeof index);
      AdaptiveFront target(mesh, std::vector<double>{1.0});
      std::istringstream stream(changed);
      try {
        target.load(stream);
        ADD_FAILURE() << "member at byte " << member << " is " << index;
      } catch (const std::runtime_error& error) {
        const std::string expected = "cell " + std::to_string(cell) + " of the front has an index that leads nowhere";
        EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
      }
    }
}

TEST(AdaptiveFront, RefusesMeshesSpeedsAndRulesThatMakeNoSense) {
  const SpaceMesh mesh = make_box(2, 2);
  EXPECT_THROW(AdaptiveFront(mesh, std::vector<double>{}), std::invalid_argument);
  EXPECT_THROW(AdaptiveFront(mesh, std::vector<double>{-1.0}), std::invalid_argument);
  AdaptiveFrontRules rules;
  rules.causality = 1.5;
  EXPECT_THROW(AdaptiveFront(mesh, std::vector<double>{1.0}, rules), std::invalid_argument);
  BoxMesh periodic;
  periodic.cells = {4, 4, 1};
  periodic.periodic = {{"left", "right"}};
  EXPECT_THROW(AdaptiveFront(make_box_mesh(periodic), std::vector<double>{1.0}), std::invalid_argument);
  BoxMesh cube;
  cube.dimension = 3;
  EXPECT_THROW(AdaptiveFront(make_box_mesh(cube), std::vector<double>{1.0}), std::invalid_argument);
  AdaptiveFront front(mesh, std::vector<double>{1.0});
  EXPECT_THROW(front.mark_crack(0, 1), std::invalid_argument);  // on the boundary
  EXPECT_THROW(front.mark_crack(0, 8), std::invalid_argument);  // no edge
  EXPECT_THROW(front.split_edge(0, 8, 0.5), std::invalid_argument);
}

}  // namespace
}  // namespace tentpole
