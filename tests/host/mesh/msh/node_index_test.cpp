#include "host/mesh/msh/node_index.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "host/mesh/space_mesh.hpp"

namespace tentpole {
namespace {

constexpr std::int64_t lowest = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t highest = std::numeric_limits<std::int64_t>::max();

TEST(NodeIndex, FindsEveryLabelAndNoOther) {
  const std::vector<std::int64_t> lists[] = {
      {1, 2, 3, 4},         {7, 3, 5, 4},          {-2, 0, 1}, {5}, {1, 1000000000000, 17},
      {lowest, 0, highest}, {highest, highest - 1}};
  for (const auto& labels : lists) {
    const NodeIndex index(labels);
    for (std::size_t i = 0; i < labels.size(); ++i) EXPECT_EQ(index.find(labels[i]), static_cast<std::int32_t>(i));
    for (const std::int64_t other : {lowest + 1, std::int64_t{-1}, std::int64_t{6}, std::int64_t{42}, highest - 2})
      EXPECT_EQ(index.find(other), none) << other;
    EXPECT_FALSE(index.duplicate());
  }
}

TEST(NodeIndex, OfNoNodesFindsNothing) {
  const NodeIndex index({});
  EXPECT_EQ(index.find(0), none);
}

TEST(NodeIndex, TellsALabelThatIsThereTwice) {
  const std::vector<std::int64_t> lists[] = {{1, 2, 3, 2}, {1, 1000000000000, 17, 1000000000000}};
  for (const auto& labels : lists)
    EXPECT_EQ(NodeIndex(labels).duplicate(), (std::pair<std::int32_t, std::int32_t>{1, 3}));
}

}  // namespace
}  // namespace tentpole
