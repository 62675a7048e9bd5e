#include "host/output/history.hpp"

#include <sstream>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "host/output/file_identity.hpp"
#include "tests/temporary_folder.hpp"

namespace tentpole {
namespace {

std::vector<std::vector<double>> read_rows(const TemporaryFolder& folder) {
  std::istringstream text(folder.read("history.csv"));
  std::vector<std::vector<double>> rows;
  std::string line, cell;
  std::getline(text, line);
  while (std::getline(text, line)) {
    rows.emplace_back();
    for (std::istringstream row(line); std::getline(row, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

TEST(History, HasOneRowPerTimeFromZeroToTheEnd) {
  TemporaryFolder folder;
  History history(folder.path(), 0.3, 1);
  history.finish(1, {.cells = 7});
  const auto rows = read_rows(folder);
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows.front()[0], 0);
  EXPECT_EQ(rows.back()[0], 1);
  for (const auto& row : rows) {
    ASSERT_EQ(row.size(), 17u);
    EXPECT_EQ(row[15], 7);
  }
}

TEST(History, SpreadsWorkLinearlyAndKeepsTheTotal) {
  TemporaryFolder folder;
  History history(folder.path(), 0.25, 1);
  history.add_interval(0.0, 1.0, {.external_work = 8});
  history.add_interval(0.4, 0.6, {.external_work = 2, .numerical = 4, .fracture = 6, .friction = 8});
  history.add_interval(0.5, 0.75, {.friction = 1});
  history.finish(1, {});
  const auto rows = read_rows(folder);
  const double work[] = {0, 2, 5, 8, 10}, numerical[] = {0, 0, 2, 4, 4}, friction[] = {0, 0, 4, 9, 9};
  for (int row = 0; row < 5; ++row) {
    EXPECT_NEAR(rows[row][3], work[row], 1e-14);
    EXPECT_NEAR(rows[row][4], numerical[row], 1e-14);
    EXPECT_NEAR(rows[row][5], 1.5 * numerical[row], 1e-14);
    EXPECT_NEAR(rows[row][6], friction[row], 1e-14);
  }
  EXPECT_EQ(rows[4][3], 10);
}

TEST(History, EnergiesDoNotDependOnTheOrder) {
  TemporaryFolder forward, backward;
  const double terms[] = {1e20, 1.0, -1e20, 1e-7, 3.3, 0.1};
  for (const bool reversed : {false, true}) {
    History history((reversed ? backward : forward).path(), 1, 1);
    for (int i = 0; i < 6; ++i) {
      const double term = terms[reversed ? 5 - i : i];
      history.add_energy(1, term, 2 * term);
      history.add_interval(0, 1.3, {.numerical = term});
    }
    history.finish(1, {});
  }
  EXPECT_EQ(forward.read("history.csv"), backward.read("history.csv"));
  EXPECT_NEAR(read_rows(forward)[1][1], 4.4000001, 1e-15);
}

TEST(History, WritesOnlyRowsThatTheFrontHasPassed) {
  TemporaryFolder folder;
  History history(folder.path(), 0.25, 1);
  history.finish(0, {});
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "history.csv"));
  history.finish(0.6, {.cells = 1});
  EXPECT_EQ(read_rows(folder).size(), 3u);
  history.finish(1, {.cells = 2});
  const auto rows = read_rows(folder);
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[2][15], 1);
  EXPECT_EQ(rows[3][15], 2);
  EXPECT_THROW(history.add_energy(0, 1, 1), std::logic_error);
  EXPECT_THROW(history.add_surface(0, 1, uniform_crack_edge(1, 0.5)), std::logic_error);
}

/// Half of a length of 4 has failed.
TEST(History, SumsUpTheSurfacesOfEachRow) {
  TemporaryFolder folder;
  History history(folder.path(), 0.5, 1);
  history.add_surface(1, 3, uniform_crack_edge(2, 0.5));
  CrackEdgeState half_failed = uniform_crack_edge(2, 0.25);
  half_failed.damage[1] = 0.9995;
  history.add_surface(1, 1, half_failed);
  history.finish(1, {});
  const auto rows = read_rows(folder);
  EXPECT_EQ(rows[0][7], 0);
  EXPECT_EQ(rows[0][8], 0);
  EXPECT_NEAR(rows[1][7], 0.5, 1e-15);
  EXPECT_NEAR(rows[1][8], (3 * 0.5 + 0.5 * (0.25 + 0.9995)) / 4, 1e-15);
  EXPECT_EQ(rows[1][9], 0.9995);
  EXPECT_EQ(rows[2][8], 0) << "nothing is carried over";
}

TEST(History, CountsEventsByTheirTimes) {
  TemporaryFolder folder;
  History history(folder.path(), 0.25, 1);
  history.add_event(CrackEvent::nucleation, 0.5);
  history.add_event(CrackEvent::extension, 0.51);
  history.add_event(CrackEvent::coalescence, 0.1);
  history.finish(0.6, {});
  history.add_event(CrackEvent::extension, 0.3);  // late: its row is written
  history.add_event(CrackEvent::branch, 1);
  history.add_event(CrackEvent::branch, 1.1);
  history.finish(1, {});
  const auto rows = read_rows(folder);
  const double nucleations[] = {0, 0, 1, 1, 1}, extensions[] = {0, 0, 0, 2, 2}, branches[] = {0, 0, 0, 0, 1},
               coalescences[] = {0, 1, 1, 1, 1};
  for (int row = 0; row < 5; ++row) {
    EXPECT_EQ(rows[row][10], nucleations[row]);
    EXPECT_EQ(rows[row][11], extensions[row]);
    EXPECT_EQ(rows[row][12], branches[row]);
    EXPECT_EQ(rows[row][13], coalescences[row]);
  }
}

TEST(History, GoesOnBitwiseFromACheckpoint) {
  TemporaryFolder whole, resumed;
  const auto early = [](History& history) {
    history.add_interval(0, 0.7, {.external_work = 1.0 / 3});
    history.add_event(CrackEvent::nucleation, 0.2);
    history.add_surface(3, 0.3, uniform_crack_edge(1, 0.7));
  };
  const auto late = [](History& history) {
    history.add_interval(0.5, 1, {.external_work = 0.1});
    history.add_event(CrackEvent::nucleation, 0.9);
    history.add_surface(3, 0.1, uniform_crack_edge(1, 0.1));
  };
  History history(whole.path(), 0.25, 1);
  early(history), history.finish(0.5, {}), late(history), history.finish(1, {});

  std::stringstream checkpoint;
  {
    History interrupted(resumed.path(), 0.25, 1);
    early(interrupted), interrupted.finish(0.5, {}), interrupted.save(checkpoint);
    late(interrupted), interrupted.finish(0.8, {});
  }
  History next(resumed.path(), 0.25, 1);
  next.load(checkpoint);
  late(next), next.finish(1, {});
  EXPECT_EQ(whole.read("history.csv"), resumed.read("history.csv"));
}

TEST(History, RefusesToResumeWithoutItsFile) {
  TemporaryFolder first, second;
  std::stringstream checkpoint;
  History history(first.path(), 0.5, 1);
  history.finish(0.5, {});
  history.save(checkpoint);
  History other(second.path(), 0.5, 1);
  other.load(checkpoint);
  WrittenFiles files;
  other.add_written(files);
  EXPECT_THROW(require_written(files), std::runtime_error);
  EXPECT_THROW(other.finish(1, {}), FolderLost);
}

}  // namespace
}  // namespace tentpole
