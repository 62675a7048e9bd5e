#include "host/run/memory_need.hpp"

#include <gtest/gtest.h>

#include "host/output/history.hpp"

// Against the memory that a run really takes: tests/host/command_line/memory_test.py.
namespace tentpole {
namespace {

Case line_of(int num_cells) {
  Case settings;
  settings.domain.dimension = 1;
  settings.domain.cells = {num_cells, 0, 0};
  settings.degree = 1;
  settings.end_time = 1;
  settings.output.history_interval = 0.5;
  return settings;
}

TEST(MemoryNeed, OfALongLineIsHundredsOfBytesPerCell) {
  const MemoryNeed need = memory_need(line_of(190'000'000), 190e6, 190e6);
  EXPECT_GT(need.peak(), 300 * 190e6);
  EXPECT_LT(need.peak(), 600 * 190e6);
}

TEST(MemoryNeed, GrowsWithTheUnknownsOfAnElement) {
  Case settings = line_of(1000);
  const double lowest = memory_need(settings, 1001, 1000).run;
  settings.degree = 7;
  const double added = (36 - 3) * 8 * 1000;  // unknowns, bytes, cells
  EXPECT_GE(memory_need(settings, 1001, 1000).run, lowest + added);
}

TEST(MemoryNeed, OfOutputIsThatOfAllRows) {
  Case settings = line_of(10);
  settings.output.history_interval = 1e-7;
  EXPECT_DOUBLE_EQ(memory_need(settings, 11, 10).output, 1e7 * History::bytes_per_row());
  EXPECT_GT(memory_need(settings, 11, 10).output, 50e9);  // ten exact sums a row
}

TEST(MemoryNeed, CellsOfBoxesAreCountedBeforeTheyAreMade) {
  DomainSettings domain;
  domain.dimension = 3;
  domain.cells = {2, 3, 4};
  EXPECT_EQ(box_counts(domain).vertices, 60);
  EXPECT_EQ(box_counts(domain).cells, 144);
}

TEST(MemoryNeed, RefusalNamesTheFiguresAndTheWayOut) {
  Case settings = line_of(10);
  settings.path = "long.toml";
  EXPECT_NO_THROW(check_memory(settings, 11, 10));
  try {
    check_memory(settings, 2e12, 2e12);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("long.toml: domain.cells: 2e+12 cells need about "))
        << error.what();
    EXPECT_TRUE(std::string(error.what()).ends_with(". Give fewer cells or a lower degree.")) << error.what();
  }
}

}  // namespace
}  // namespace tentpole
