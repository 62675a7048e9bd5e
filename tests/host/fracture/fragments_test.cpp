#include "host/fracture/fragments.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

/// A row of four cells of mass 1, 2, 3, 4 and velocity (i, 1, 0), bonded by the given damages.
std::vector<CellContent> row_of_cells() {
  std::vector<CellContent> cells;
  for (int i = 0; i < 4; ++i) {
    const double mass = i + 1;
    cells.push_back({0.5, mass, {mass * i, mass, 0}});
  }
  return cells;
}

std::vector<CellConnection> bonds(double first, double second, double third) {
  return {{0, 1, first}, {2, 1, second}, {2, 3, third}};
}

TEST(FindFragments, BodyWithoutSurfacesIsOneFragment) {
  const Fragments result = find_fragments(row_of_cells(), bonds(0, 0, 0));
  ASSERT_EQ(result.fragments.size(), 1u);
  EXPECT_EQ(result.fragments[0].num_cells, 4);
  EXPECT_EQ(result.fragments[0].content.volume, 2);
  EXPECT_EQ(result.fragments[0].content.mass, 10);
  EXPECT_EQ(result.fragments[0].velocity(), (std::array<double, 3>{2, 1, 0}));
  EXPECT_EQ(result.fragment_of_cell, (std::vector<std::int32_t>{0, 0, 0, 0}));
}

TEST(FindFragments, DamageOfTheLimitSeparatesAndLessDoesNot) {
  EXPECT_EQ(find_fragments(row_of_cells(), bonds(0, 0.989, 0)).fragments.size(), 1u);
  const Fragments result = find_fragments(row_of_cells(), bonds(0, separating_damage, 0));
  ASSERT_EQ(result.fragments.size(), 2u);
  EXPECT_EQ(result.fragment_of_cell, (std::vector<std::int32_t>{0, 0, 1, 1}));
  EXPECT_EQ(result.fragments[1].first_cell, 2);
  EXPECT_EQ(result.fragments[1].content.mass, 7);
  EXPECT_DOUBLE_EQ(result.fragments[1].velocity()[0], 18.0 / 7);
}

TEST(FindFragments, CrackThatEndsInsideSeparatesNothing) {
  // four cells around a vertex: one cut leaves a way round, a second one does not
  const std::vector<CellContent> cells(4, CellContent{1, 1, {}});
  std::vector<CellConnection> ring{{0, 1, 1}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
  EXPECT_EQ(find_fragments(cells, ring).fragments.size(), 1u);
  ring[2].damage = 1;
  const Fragments result = find_fragments(cells, ring);
  EXPECT_EQ(result.fragments.size(), 2u);
  EXPECT_EQ(result.fragment_of_cell, (std::vector<std::int32_t>{0, 1, 1, 0}));
}

TEST(FindFragments, CellsWithoutConnectionsAreFragments) {
  EXPECT_EQ(find_fragments(row_of_cells(), {}).fragments.size(), 4u);
  EXPECT_TRUE(find_fragments({}, {}).fragments.empty());
}

TEST(FindFragments, OrderAndDirectionOfConnectionsDoNotMatter) {
  // a 30 x 30 grid of squares with random cuts
  const int n = 30;
  const std::vector<CellContent> cells(n * n, CellContent{1, 1, {}});
  std::mt19937 generator(3);
  std::vector<CellConnection> connections;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (i + 1 < n) connections.push_back({n * i + j, n * i + n + j, generator() % 2 ? 1.0 : 0.5});
      if (j + 1 < n) connections.push_back({n * i + j, n * i + j + 1, generator() % 2 ? 1.0 : 0.5});
    }
  const Fragments first = find_fragments(cells, connections);
  EXPECT_GT(first.fragments.size(), 10u);
  EXPECT_LT(first.fragments.size(), 400u);
  for (const CellConnection& connection : connections)
    EXPECT_TRUE(connection.damage >= separating_damage ||
                first.fragment_of_cell[connection.first] == first.fragment_of_cell[connection.second]);
  std::shuffle(connections.begin(), connections.end(), generator);
  for (CellConnection& connection : connections) std::swap(connection.first, connection.second);
  EXPECT_EQ(find_fragments(cells, connections).fragment_of_cell, first.fragment_of_cell);
}

TEST(FragmentVelocity, IsZeroWithoutMass) {
  EXPECT_EQ(Fragment().velocity(), (std::array<double, 3>{}));
}

}  // namespace
}  // namespace tentpole
