#include "host/output/crack_series.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/output/crack_grid.hpp"
#include "tests/temporary_folder.hpp"

namespace tentpole {
namespace {

/// From (1, 2) to (4, 6) um, two Gauss points.
CrackSegment slanted_edge(std::int64_t id) {
  CrackSegment segment;
  segment.end = {{{1e-6, 2e-6, 0}, {4e-6, 6e-6, 0}}};
  segment.id = id;
  segment.mode = CrackMode::slip;
  segment.num_points = 2;
  segment.damage = {0.25, 1};
  segment.opening = {0, 3e-9};
  return segment;
}

TEST(CrackGrid, ShowsEveryValueAtItsGaussPoint) {
  const UnstructuredGrid grid = crack_grid(2, 5e-8, std::vector{slanted_edge(7)});
  const double place[] = {0, 0.5 - 0.5 / std::sqrt(3), 0.5 + 0.5 / std::sqrt(3), 1};
  ASSERT_EQ(grid.points.size(), 12u);
  for (int point = 0; point < 4; ++point) {
    EXPECT_NEAR(grid.points[3 * point], 1e-6 + 3e-6 * place[point], 1e-21);
    EXPECT_NEAR(grid.points[3 * point + 1], 2e-6 + 4e-6 * place[point], 1e-21);
  }
  EXPECT_EQ(grid.point_data[0].values, (std::vector<double>{0.25, 0.25, 1, 1}));
  EXPECT_EQ(grid.point_data[1].values, (std::vector<double>{0, 0, 3e-9, 3e-9}));
  EXPECT_EQ(grid.connectivity, (std::vector<std::int64_t>{0, 1, 1, 2, 2, 3}));
  EXPECT_EQ(grid.offsets, (std::vector<std::int64_t>{0, 2, 4, 6}));
  EXPECT_EQ(grid.types, (std::vector<std::uint8_t>{3, 3, 3}));
  EXPECT_EQ(grid.cell_numbers[0].values, (std::vector<std::int64_t>{7, 7, 7}));
  EXPECT_EQ(grid.cell_numbers[1].values, (std::vector<std::int64_t>{2, 2, 2}));
  EXPECT_EQ(grid.time, 5e-8);
}

TEST(CrackGrid, HasOneVertexPerSurfaceInOneDimension) {
  CrackSegment first = slanted_edge(1), second = slanted_edge(0);
  for (CrackSegment* segment : {&first, &second}) segment->end[1] = segment->end[0], segment->num_points = 1;
  second.damage[0] = 0.5;
  const UnstructuredGrid grid = crack_grid(1, 0, std::vector{first, second});
  EXPECT_EQ(grid.points.size(), 6u);
  EXPECT_EQ(grid.types, (std::vector<std::uint8_t>{1, 1}));
  EXPECT_EQ(grid.offsets, (std::vector<std::int64_t>{0, 1, 2}));
  EXPECT_EQ(grid.point_data[0].values, (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(grid.cell_numbers[0].values, (std::vector<std::int64_t>{0, 1}));
}

TEST(CrackGrid, RefusesSegmentsWithoutOrWithTooManyPoints) {
  CrackSegment segment = slanted_edge(3);
  for (const int num_points : {0, -1, max_degree + 2}) {
    segment.num_points = num_points;
    EXPECT_THROW(crack_grid(2, 0, std::vector{segment}), std::invalid_argument);
  }
  segment.num_points = 2;
  EXPECT_THROW(crack_grid(1, 0, std::vector{segment}), std::invalid_argument);
}

TEST(CrackGrid, PutsThePartsOfAnEdgeInOrder) {
  CrackSegment first = slanted_edge(3), second = slanted_edge(3), other = slanted_edge(1);
  second.begin = 0.5;
  first.damage[0] = 0.125;
  const UnstructuredGrid grid = crack_grid(2, 0, std::vector{second, first, other});
  EXPECT_EQ(grid.cell_numbers[0].values, (std::vector<std::int64_t>{1, 1, 1, 3, 3, 3, 3, 3, 3}));
  EXPECT_EQ(grid.point_data[0].values[4], 0.125);
}

void add(CrackSeries& cracks, int index, const std::vector<CrackSegment>& segments) {
  for (const CrackSegment& segment : segments) cracks.add(index, segment);
}

TEST(CrackSeries, WritesOneFilePerTimeThatTheFrontHasPassed) {
  TemporaryFolder folder;
  CrackSeries cracks({.dimension = 2, .folder = folder.path(), .times = {0, 1e-8, 2e-8}});
  EXPECT_EQ(cracks.range(0, 1e-8).first, 0);
  EXPECT_EQ(cracks.range(0, 1e-8).last, 2);
  cracks.add(0, slanted_edge(0));
  cracks.finish(0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "cracks_0000.vtkhdf"));
  cracks.finish(1.5e-8);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "cracks_0002.vtkhdf"));
  EXPECT_THROW(cracks.add(1, slanted_edge(0)), std::logic_error);
  cracks.add(2, slanted_edge(0));
  cracks.finish(2e-8);
  const auto series = nlohmann::json::parse(folder.read("cracks.vtkhdf.series"));
  ASSERT_EQ(series["files"].size(), 3u);
  for (int index = 0; index < 3; ++index) {
    const std::string name = "cracks_000" + std::to_string(index) + ".vtkhdf";
    EXPECT_EQ(series["files"][index]["name"], name);
    EXPECT_EQ(series["files"][index]["time"], 1e-8 * index);
    EXPECT_FALSE(folder.read(name).empty());
  }
}

TEST(CrackSeries, GivesTheSameBytesForAnyOrderAndAfterACheckpoint) {
  TemporaryFolder whole, resumed;
  std::vector<CrackSegment> early = {slanted_edge(0), slanted_edge(1)},
                            late = {slanted_edge(0), slanted_edge(1), slanted_edge(4)};
  const std::vector<double> times = {1e-8, 2e-8};
  CrackSeries cracks({.dimension = 2, .folder = whole.path(), .times = times});
  add(cracks, 0, early), add(cracks, 1, late);
  cracks.finish(2e-8);

  std::reverse(early.begin(), early.end());
  std::stringstream checkpoint;
  {
    CrackSeries interrupted({.dimension = 2, .folder = resumed.path(), .times = times});
    add(interrupted, 0, early);
    interrupted.add(1, late[2]);
    interrupted.finish(1e-8);
    interrupted.save(checkpoint);
    interrupted.finish(2e-8);  // what the resumed run replaces
  }
  CrackSeries next({.dimension = 2, .folder = resumed.path(), .times = times});
  next.load(checkpoint);
  next.add(1, late[1]), next.add(1, late[0]);
  next.finish(2e-8);
  for (const char* name : {"cracks_0000.vtkhdf", "cracks_0001.vtkhdf", "cracks.vtkhdf.series"})
    EXPECT_TRUE(whole.read(name) == resumed.read(name)) << name;
  EXPECT_FALSE(whole.read("cracks_0000.vtkhdf") == whole.read("cracks_0001.vtkhdf"));
}

TEST(CrackSeries, RefusesOtherDimensionsUnsortedTimesAndForeignCheckpoints) {
  TemporaryFolder folder;
  EXPECT_THROW(CrackSeries({.dimension = 3, .folder = folder.path(), .times = {0}}), std::invalid_argument);
  EXPECT_THROW(CrackSeries({.dimension = 2, .folder = folder.path(), .times = {1, 1}}), std::invalid_argument);
  CrackSeries longer({.dimension = 2, .folder = folder.path(), .times = {0, 1, 2}});
  longer.finish(2);
  std::stringstream checkpoint;
  longer.save(checkpoint);
  CrackSeries shorter({.dimension = 2, .folder = folder.path(), .times = {0, 1}});
  EXPECT_THROW(shorter.load(checkpoint), std::runtime_error);
}

}  // namespace
}  // namespace tentpole
