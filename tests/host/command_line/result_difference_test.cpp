#include "host/command_line/result_difference.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/output/crack_series.hpp"
#include "host/output/vtkhdf_writer.hpp"
#include "tests/temporary_folder.hpp"

namespace tentpole {
namespace {

/// A snapshot of one triangle.
void write_snapshot(const std::filesystem::path& folder, const std::string& name, const std::vector<double>& stress) {
  std::filesystem::create_directories(folder);
  UnstructuredGrid grid;
  grid.points = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  grid.connectivity = {0, 1, 2};
  grid.offsets = {0, 3};
  grid.types = {5};
  grid.point_data = {{"energy", 1, {1, 2, 3}}, {"stress", 1, stress}};
  write_vtkhdf(folder, name, grid);
}

TEST(ResultDifference, IsRelativeToTheLargestValueOfTheWholeRun) {
  const TemporaryFolder root;
  const auto a = root.path() / "a", b = root.path() / "b";
  write_snapshot(a, "snapshot_0000.vtkhdf", {0, 0, 1});
  write_snapshot(a, "snapshot_0001.vtkhdf", {0, 0, -400});
  write_snapshot(b, "snapshot_0000.vtkhdf", {0, 0.5, 1});
  write_snapshot(b, "snapshot_0001.vtkhdf", {0, 0, -400});
  const ResultDifference difference = compare_results(a, b);
  EXPECT_DOUBLE_EQ(difference.largest, 0.5 / 400);
  EXPECT_EQ(difference.where, "stress in snapshot_0000.vtkhdf");
  EXPECT_EQ(difference.num_values, 12);
  EXPECT_EQ(difference.num_equal, 11);
}

TEST(ResultDifference, SeesCracks) {
  const TemporaryFolder root;
  const auto a = root.path() / "a", b = root.path() / "b", c = root.path() / "c";
  for (const auto& [folder, damage] : {std::pair{&a, 0.5}, std::pair{&b, 0.375}, std::pair{&c, -1.0}}) {
    std::filesystem::create_directories(*folder);
    CrackSeries cracks({.dimension = 2, .folder = *folder, .times = {1e-8, 2e-8}});
    CrackSegment segment;
    segment.end[1] = {1e-6, 0, 0};
    segment.num_points = 2;
    segment.damage = {0.25, damage};
    for (int repeat = 0; repeat < (damage < 0 ? 2 : 1); ++repeat) cracks.add(1, segment);
    cracks.finish(2e-8);
  }
  const ResultDifference difference = compare_results(a, b);
  EXPECT_DOUBLE_EQ(difference.largest, 0.125 / 0.5);
  EXPECT_EQ(difference.where, "damage in cracks_0001.vtkhdf");
  EXPECT_EQ(difference.num_values, 8);  // damage and opening at four points
  EXPECT_EQ(difference.num_equal, 6);
  EXPECT_THROW(compare_results(a, c), std::runtime_error);
}

TEST(ResultDifference, OfEqualResultsIsZero) {
  const TemporaryFolder root;
  for (const char* name : {"a", "b"}) {
    write_snapshot(root.path() / name, "snapshot_0000.vtkhdf", {0, 0, 0});
    root.write(std::string(name) + "/probe_mid.csv", "time,ux\n0,1\n1,2\n");
  }
  const ResultDifference difference = compare_results(root.path() / "a", root.path() / "b");
  EXPECT_EQ(difference.largest, 0);
  EXPECT_EQ(difference.num_equal, 10);
  EXPECT_EQ(difference.num_values, 10);
}

TEST(ResultDifference, ProbesAreComparedColumnByColumn) {
  const TemporaryFolder root;
  root.write("a/probe_mid.csv", "time,ux,sxx\n0,1,1e8\n1,2,2e8\n");
  root.write("b/probe_mid.csv", "time,ux,sxx\n0,1,1e8\n1,2.5,2e8\n");
  const ResultDifference difference = compare_results(root.path() / "a", root.path() / "b");
  EXPECT_DOUBLE_EQ(difference.largest, 0.25);
  EXPECT_EQ(difference.where, "probe_mid.csv ux in probe_mid.csv");
}

TEST(ResultDifference, HistoryStandsInWhereThereIsNoOtherOutput) {
  const TemporaryFolder root;
  root.write("a/history.csv", "time,kinetic\n0,4\n");
  root.write("b/history.csv", "time,kinetic\n0,3\n");
  EXPECT_DOUBLE_EQ(compare_results(root.path() / "a", root.path() / "b").largest, 0.25);
}

TEST(ResultDifference, ValuesThatAreNotNumbersAreInfinitelyFar) {
  const TemporaryFolder root;
  write_snapshot(root.path() / "a", "snapshot_0000.vtkhdf", {1, 1, 1});
  write_snapshot(root.path() / "b", "snapshot_0000.vtkhdf", {1, std::nan(""), 1});
  EXPECT_EQ(compare_results(root.path() / "a", root.path() / "b").largest, std::numeric_limits<double>::infinity());
}

TEST(ResultDifference, MissingFilesAndDifferentSizesAreErrors) {
  const TemporaryFolder root;
  write_snapshot(root.path() / "a", "snapshot_0000.vtkhdf", {1, 1, 1});
  std::filesystem::create_directories(root.path() / "b");
  EXPECT_THROW(compare_results(root.path() / "a", root.path() / "b"), std::runtime_error);
  root.write("c/probe_p.csv", "time\n0\n");
  root.write("d/probe_p.csv", "time\n0\n1\n");
  EXPECT_THROW(compare_results(root.path() / "c", root.path() / "d"), std::runtime_error);
}

}  // namespace
}  // namespace tentpole
