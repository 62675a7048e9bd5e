#include "host/output/run_summary.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/host/output/result_folder.hpp"

namespace tentpole {
namespace {

TEST(RunSummary, HoldsCountsSharesAndRates) {
  ResultFolder folder("summary");
  RunSummary summary;
  summary.title = "a \"quoted\" bar";
  summary.counts = {.patches = 100, .elements = 600, .dofs = 12000, .cells_max = 50};
  summary.stages.assembly = {.seconds = 1, .calls = 4};
  summary.stages.solution = {.seconds = 3, .calls = 4};
  summary.stages.total = {.seconds = 5, .calls = 1};
  summary.flops = 8e9;
  summary.energy = {.initial = 1, .external_work = 10, .kinetic = 4, .strain = 5, .numerical = 1.5};
  summary.warnings = {"degree 1 has order 1 only"};
  write_run_summary(folder.path(), summary);
  const auto json = nlohmann::json::parse(folder.read("summary.json"));
  EXPECT_EQ(json["title"], summary.title);
  EXPECT_EQ(json["counts"]["elements"], 600);
  EXPECT_EQ(json["calls"]["solution"], 4);
  EXPECT_EQ(json["percent"]["solution"], 60);
  EXPECT_EQ(json["rates"]["patches_per_s"], 20);
  EXPECT_EQ(json["rates"]["gflops"], 2);
  EXPECT_EQ(json["energy"]["balance_error"], 0.5);
  EXPECT_EQ(json["warnings"].size(), 1u);
  EXPECT_FALSE(json.contains("errors"));
  EXPECT_GT(json["machine"]["peak_resident_bytes"], 100000);
  EXPECT_GE(json["machine"]["cores"], 1);
  EXPECT_FALSE(json["build"]["compiler"].get<std::string>().empty());
  EXPECT_FALSE(json["version"].get<std::string>().empty());
}

TEST(RunSummary, NumbersThatAreNotFiniteBecomeNullAndAWarning) {
  ResultFolder folder("summary_nan");
  RunSummary summary;
  summary.energy.kinetic = std::nan("");
  summary.errors = {.displacement_l2 = INFINITY};
  write_run_summary(folder.path(), summary);
  const auto json = nlohmann::json::parse(folder.read("summary.json"));
  EXPECT_TRUE(json["energy"]["kinetic"].is_null());
  EXPECT_TRUE(json["energy"]["balance_error"].is_null());
  EXPECT_TRUE(json["errors"]["displacement_l2"].is_null());
  ASSERT_EQ(json["warnings"].size(), 3u);
  EXPECT_EQ(json["warnings"][0], "energy.kinetic is not finite (NaN)");
  EXPECT_FALSE(json.contains("rates"));
}

TEST(RunSummary, ReportsAFolderThatCannotBeWritten) {
  EXPECT_THROW(write_run_summary("/proc/no_such_folder", RunSummary{}), std::runtime_error);
}

}  // namespace
}  // namespace tentpole
