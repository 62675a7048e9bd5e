#include "host/mesh/point_finder.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

TEST(PointFinder, FindsPointsWithinTheToleranceAndNoOthers) {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {1, 2, 3}, {1, 2, 3 + 1e-7}, {-4, 0.5, 0}};
  const PointFinder finder(points, 1e-6);
  EXPECT_EQ(finder.find({1, 0, 0}), 1);
  EXPECT_EQ(finder.find({1 + 9e-7, -9e-7, 0}), 1);
  EXPECT_EQ(finder.find({1 + 2e-6, 0, 0}), none);
  EXPECT_EQ(finder.find({1, 2, 3 + 1e-7}), 2) << "the smallest index";
  EXPECT_EQ(finder.find(points[2], 2), 3);
  EXPECT_EQ(finder.find(points[4], 4), none);
}

TEST(PointFinder, IsQuickWhereOnePointIsFarFromAllOthers) {
  // All but the last lie in one slot: looking at each of them for each would take a minute.
  std::vector<Point> points;
  for (int x = 0; x < 400; ++x)
    for (int y = 0; y < 400; ++y) points.push_back({x / 400.0, y / 400.0, 0});
  points.push_back({1e9, 0, 0});
  const PointFinder finder(points, 1e-9);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(finder.find(points[i]), static_cast<std::int32_t>(i));
    ASSERT_EQ(finder.find(points[i], static_cast<std::int32_t>(i)), none);
  }
}

TEST(PointFinder, TakesPointsThatAreAllButOne) {
  for (const double length : {0.0, 5e-324, 1e-310, 1e-300}) {
    const std::vector<Point> points{{0, 0, 0}, {length, 0, 0}};
    EXPECT_EQ(PointFinder(points, 0).find({length, 0, 0}, 1), length > 0 ? none : 0) << length;
  }
}

}  // namespace
}  // namespace tentpole
