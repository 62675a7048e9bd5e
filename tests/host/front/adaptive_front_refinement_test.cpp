#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/front/adaptive_front.hpp"
#include "host/mesh/box_mesh.hpp"
#include "host/mesh/insertion_sort.hpp"
#include "tests/host/front/polygon_mesh.hpp"
#include "tests/host/front/random_meshes.hpp"
#include "tests/host/front/random_operations.hpp"

namespace tentpole {
namespace {

const std::vector<double> unit_speed{1.0};

SpaceMesh make_box(int dimension, int n) {
  BoxMesh box;
  box.dimension = dimension;
  box.cells = {n, n, 1};
  return make_box_mesh(box);
}

/// What a record says of the geometry: the new vertex lies on the parent's plane, and the children are what is listed.
void expect_record_fits(const AdaptiveFront& front, const CellSplit& split) {
  const FrontMesh& mesh = front.mesh();
  EXPECT_LT(split.lower_corner, split.higher_corner);
  const int lower = split.parent_vertex[split.lower_corner], higher = split.parent_vertex[split.higher_corner];
  const FrontSimplex parent = mesh.simplex(split.parent_vertex);
  for (int axis = 0; axis < mesh.dimension(); ++axis)
    EXPECT_NEAR(mesh.position(split.vertex)[axis],
                (1 - split.fraction) * mesh.position(lower)[axis] + split.fraction * mesh.position(higher)[axis],
                1e-15);
  EXPECT_NEAR(time_at(parent, mesh.position(split.vertex)), mesh.time(split.vertex), 1e-14);
  const std::array<int, 2> replaced{split.higher_corner, split.lower_corner};
  for (int child = 0; child < 2; ++child) {
    if (!mesh.is_alive_cell(split.child[child]) || mesh.cell(split.child[child]).serial != split.child_serial[child])
      continue;  // split again by now
    FrontVertices expected = split.parent_vertex;
    expected[replaced[child]] = split.vertex;
    insertion_sort(expected, mesh.num_corners());
    EXPECT_EQ(mesh.cell(split.child[child]).vertex, expected);
  }
}

TEST(AdaptiveFrontRefinement, BisectionOfATriangleOfABoxSplitsItsPairAtTheDiagonal) {
  AdaptiveFront front(make_box(2, 1), unit_speed);
  const std::int64_t serial = front.mesh().cell(0).serial;
  const SplitOutcome outcome = front.try_split(0);
  EXPECT_TRUE(outcome.is_done);
  ASSERT_EQ(outcome.cells.size(), 2u);
  EXPECT_EQ(outcome.cells[0].parent_serial, serial);
  for (const CellSplit& split : outcome.cells) expect_record_fits(front, split);
  EXPECT_EQ(front.mesh().num_cells(), 4);
  EXPECT_EQ(front.mesh().position(outcome.cells[0].vertex), (Point{0.5, 0.5, 0}));
  EXPECT_NO_THROW(front.check());
}

TEST(AdaptiveFrontRefinement, ClosureKeepsTheMeshConformingAndRecordsEverySplit) {
  std::mt19937_64 random(3);
  AdaptiveFront front(testing::bad_triangle_mesh(1, 6, 10, 140), unit_speed);
  bool had_closure = false;
  for (int i = 0; i < 400; ++i) {
    const int cell = testing::draw_cell(front.mesh(), random), before = front.mesh().num_cells();
    const std::int64_t serial = front.mesh().cell(cell).serial;
    const SplitOutcome outcome = front.try_split(cell);
    ASSERT_TRUE(outcome.is_done);  // a flat front refuses nothing
    ASSERT_NO_THROW(front.check());
    EXPECT_EQ(front.mesh().num_cells(), before + static_cast<int>(outcome.cells.size()));
    EXPECT_EQ(std::count_if(outcome.cells.begin(), outcome.cells.end(),
                            [&](const CellSplit& split) { return split.parent_serial == serial; }),
              1);
    for (const CellSplit& split : outcome.cells) expect_record_fits(front, split);
    had_closure |= outcome.cells.size() > 2;
  }
  EXPECT_TRUE(had_closure);
}

TEST(AdaptiveFrontRefinement, AnglesStayAboveHalfTheSmallestOneDownToGeneration12) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    AdaptiveFront front(testing::bad_triangle_mesh(seed, 4, 8, 150), unit_speed);
    const FrontMesh& mesh = front.mesh();
    const double initial = testing::smallest_angle(mesh);
    std::mt19937_64 random(seed);
    for (int target = 0; target < 6; ++target) {
      std::int32_t cell = testing::draw_cell(mesh, random);
      while (mesh.cell(cell).generation < 12) {
        const SplitOutcome outcome = front.try_split(cell);
        ASSERT_TRUE(outcome.is_done);
        cell = outcome.cells.back().child[testing::draw_below(random, 2)];
      }
    }
    ASSERT_NO_THROW(front.check());
    EXPECT_GE(testing::smallest_angle(mesh), initial / 2);
  }
}

TEST(AdaptiveFrontRefinement, RefusesASplitWhoseChildrenBreakTheProgressRule) {
  // A steep but admissible front: full pitch. Some bisections must be refused, and then nothing else may have changed.
  AdaptiveFrontRules rules;
  rules.pitch_factor = 1;
  AdaptiveFront front(testing::bad_triangle_mesh(5, 8, 5, 150), unit_speed, rules);
  std::mt19937_64 random(5);
  testing::OperationMix mix;
  mix.only_tents = true;
  testing::OperationCounts counts;
  int num_refused = 0, num_done = 0;
  for (int i = 0; i < 2000; ++i) {
    testing::random_operation(front, random, rules.causality, mix, counts);
    if (i % 20 > 0) continue;
    const int cell = testing::draw_cell(front.mesh(), random), before = front.mesh().num_cells();
    const std::int64_t serial = front.mesh().cell(cell).serial;
    const SplitOutcome outcome = front.try_split(cell);
    (outcome.is_done ? num_done : num_refused) += 1;
    EXPECT_EQ(front.mesh().cell(cell).serial == serial, !outcome.is_done);
    EXPECT_EQ(front.mesh().num_cells(), before + static_cast<int>(outcome.cells.size()));
    ASSERT_NO_THROW(front.check());
  }
  EXPECT_GT(num_refused, 3);
  EXPECT_GT(num_done, 20);
}

TEST(AdaptiveFrontRefinement, CutsAnEdgeAtAnyPointAndItsCrackWithIt) {
  AdaptiveFront front(make_box(2, 2), unit_speed);
  const int middle = 4;
  const int other = front.mesh().neighbors(middle).front();
  const int crack = front.mark_crack(middle, other);
  EXPECT_EQ(front.mark_crack(other, middle), crack);
  const SplitOutcome outcome = front.split_edge(middle, other, 0.3);
  ASSERT_TRUE(outcome.is_done);
  EXPECT_NO_THROW(front.check());
  ASSERT_EQ(outcome.cells.size(), 2u);
  for (const CellSplit& split : outcome.cells) expect_record_fits(front, split);
  ASSERT_EQ(outcome.crack_edges.size(), 1u);
  const EdgeSplit& split = outcome.crack_edges[0];
  EXPECT_EQ(split.lower, std::min(middle, other));
  EXPECT_EQ(split.crack_edge, crack);
  EXPECT_DOUBLE_EQ(split.fraction, middle < other ? 0.3 : 0.7);
  EXPECT_EQ(front.crack_edge(middle, other), none);
  EXPECT_EQ(front.crack_edge(split.lower, split.vertex), split.half[0]);
  EXPECT_EQ(front.crack_edge(split.vertex, split.higher), split.half[1]);
  EXPECT_EQ(front.cracks().at(split.vertex).size(), 2u);
  EXPECT_EQ(front.cracks().at(middle).size(), 1u);
  EXPECT_TRUE(front.cracks().is_retired(crack));
}

TEST(AdaptiveFrontRefinement, NewVerticesOnSidesAndInterfacesLieOnTheirLine) {
  SpaceMesh mesh = make_box(2, 4);
  testing::divide_into_regions(mesh, 0.5);
  AdaptiveFront front(mesh, std::vector<double>{1.0, 1.5});
  const FrontMesh& cells = front.mesh();
  std::mt19937_64 random(2);
  std::set<VertexKind> kinds;
  for (int i = 0; i < 200; ++i)
    for (const CellSplit& split : front.try_split(testing::draw_cell(cells, random)).cells) {
      const Point& position = cells.position(split.vertex);
      const bool is_on_line =
          position[0] == 0 || position[0] == 0.5 || position[0] == 1 || position[1] == 0 || position[1] == 1;
      EXPECT_EQ(cells.kind(split.vertex), is_on_line ? VertexKind::line : VertexKind::interior);
      kinds.insert(cells.kind(split.vertex));
    }
  EXPECT_EQ(kinds.size(), 2u);
  EXPECT_EQ(cells.boundary_measures(), (std::vector<double>{1, 1, 1, 1}));
}

TEST(AdaptiveFrontRefinement, HalvesIntervalsOfALine) {
  AdaptiveFront front(make_box(1, 4), unit_speed);
  const SplitOutcome outcome = front.try_split(2);
  ASSERT_TRUE(outcome.is_done);
  ASSERT_EQ(outcome.cells.size(), 1u);
  expect_record_fits(front, outcome.cells[0]);
  EXPECT_DOUBLE_EQ(front.mesh().position(outcome.cells[0].vertex)[0], 0.625);
  EXPECT_NO_THROW(front.check());
}

/// The same front with other refinement edges: those that deletions and flips could leave.
AdaptiveFront with_refinement_corners(const AdaptiveFront& front, const SpaceMesh& mesh,
                                      const std::vector<int>& corners) {
  std::ostringstream saved;
  front.save(saved);
  std::string bytes = saved.str();
  for (std::size_t id = 0; id < corners.size(); ++id) {
    FrontCell cell = front.mesh().cell(static_cast<int>(id));
    const std::string before(reinterpret_cast<const char*>(&cell), sizeof cell);
    cell.refinement_corner = static_cast<std::uint8_t>(corners[id]);
    bytes.replace(bytes.find(before), sizeof cell, reinterpret_cast<const char*>(&cell), sizeof cell);
  }
  std::istringstream stream(bytes);
  AdaptiveFront result(mesh, unit_speed);
  result.load(stream);
  return result;
}

TEST(AdaptiveFrontRefinement, ClosureEndsWhereRefinementEdgesRunRoundAVertex) {
  const SpaceMesh mesh = testing::polygon_mesh(6);
  const AdaptiveFront start(mesh, unit_speed);
  std::vector<int> corners;  // each cell (i, i + 1, centre) wants to cut the edge from i + 1 to the centre
  for (int i = 0; i < 6; ++i) corners.push_back(start.mesh().corner_of(i, i));
  AdaptiveFront front = with_refinement_corners(start, mesh, corners);
  const SplitOutcome outcome = front.try_split(0);
  EXPECT_TRUE(outcome.is_done);
  EXPECT_EQ(std::count_if(outcome.cells.begin(), outcome.cells.end(),
                          [](const CellSplit& split) { return split.parent_serial == 0; }),
            1);
  EXPECT_NO_THROW(front.check());
}

TEST(AdaptiveFrontRefinement, BisectsOnAfterDeletionsAndFlips) {
  std::mt19937_64 random(11);
  testing::OperationMix mix;
  mix.max_cells = 2000;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    AdaptiveFront front(testing::bad_triangle_mesh(seed, 6, 5, 150), unit_speed);
    testing::OperationCounts counts;
    for (int i = 0; i < 2000; ++i) testing::random_operation(front, random, 0.95, mix, counts);
    // Every cell can be bisected again and again, whatever deletions and flips have left.
    for (int i = 0; i < 500; ++i) front.try_split(testing::draw_cell(front.mesh(), random));
    EXPECT_NO_THROW(front.check());
  }
}

}  // namespace
}  // namespace tentpole
