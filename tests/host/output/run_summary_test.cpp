#include "host/output/run_summary.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/temporary_folder.hpp"

namespace tentpole {
namespace {

TEST(RunSummary, HoldsCountsSharesAndRates) {
  TemporaryFolder folder;
  RunSummary summary;
  summary.title = "a \"quoted\" bar";
  summary.counts = {.patches = 100, .elements = 600, .dofs = 12000, .cells_max = 50};
  summary.stages.assembly = {.seconds = 1};
  summary.stages.solution = {.seconds = 3};
  summary.stages.total = {.seconds = 5};
  summary.flops = 8e9;
  summary.energy = {.initial = 1, .external_work = 10, .kinetic = 4, .strain = 5, .numerical = 1.5};
  summary.warnings = {"degree 1 has order 1 only"};
  write_run_summary(folder.path(), summary);
  const auto json = nlohmann::json::parse(folder.read("summary.json"));
  EXPECT_EQ(json["title"], summary.title);
  EXPECT_EQ(json["counts"]["elements"], 600);
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

TEST(RunSummary, HoldsRefinementAndFracture) {
  TemporaryFolder folder;
  RunSummary summary;
  summary.counts = {.rejected = 3, .min_size_hits = 1, .splits = 40, .deletions = 12, .flips = 5, .inclined = 2};
  summary.counts.smallest_cell = 5e-7;
  summary.counts.largest_cell = 5e-5;
  summary.energy = {.external_work = 10, .kinetic = 4, .strain = 3, .fracture = 2, .friction = 0.5, .numerical = 0.5};
  summary.fracture = {.nucleations = 2, .extensions = 9, .branches = 1, .coalescences = 1, .crack_length = 2e-4};
  summary.fracture.surface_length = 3e-4;
  summary.fracture.first_nucleation = {.time = 6e-8, .position = {1e-4, 2e-4, 0}};
  summary.fracture.damage_mean = 0.75;
  summary.fracture.damage_max = 1;
  write_run_summary(folder.path(), summary);
  auto json = nlohmann::json::parse(folder.read("summary.json"));
  EXPECT_EQ(json["counts"]["min_size_hits"], 1);
  EXPECT_EQ(json["counts"]["splits"], 40);
  EXPECT_EQ(json["counts"]["deletions"], 12);
  EXPECT_EQ(json["counts"]["flips"], 5);
  EXPECT_EQ(json["counts"]["inclined"], 2);
  EXPECT_EQ(json["counts"]["smallest_cell"], 5e-7);
  EXPECT_EQ(json["counts"]["largest_cell"], 5e-5);
  EXPECT_EQ(json["energy"]["balance_error"], 0);
  EXPECT_EQ(json["fracture"]["extensions"], 9);
  EXPECT_EQ(json["fracture"]["surface_length"], 3e-4);
  EXPECT_EQ(json["fracture"]["first_nucleation"]["time"], 6e-8);
  EXPECT_EQ(json["fracture"]["first_nucleation"]["position"][1], 2e-4);
  EXPECT_EQ(json["fracture"]["damage_mean"], 0.75);
  EXPECT_EQ(json["fracture"]["damage_max"], 1);
  EXPECT_EQ(json["fracture"]["spalled"], false);
  EXPECT_TRUE(json["fracture"]["fragments"].empty());

  summary.fracture.fragments = {{.size = 1e-7, .mass = 3.69e-4, .mean_velocity = {-12, 0, 0}},
                                {.size = 1e-7, .mass = 3.69e-4, .mean_velocity = {12, 0.5, 0}}};
  write_run_summary(folder.path(), summary);
  json = nlohmann::json::parse(folder.read("summary.json"));
  EXPECT_EQ(json["fracture"]["spalled"], true);
  ASSERT_EQ(json["fracture"]["fragments"].size(), 2u);
  EXPECT_EQ(json["fracture"]["fragments"][0]["mass"], 3.69e-4);
  EXPECT_EQ(json["fracture"]["fragments"][1]["mean_velocity"], (std::vector<double>{12, 0.5, 0}));
}

TEST(RunSummary, NumbersThatAreNotFiniteBecomeNullAndAWarning) {
  TemporaryFolder folder;
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
  EXPECT_THROW(write_run_summary(OutputFolder("/proc/no_such_folder"), RunSummary{}), std::runtime_error);
}

}  // namespace
}  // namespace tentpole
