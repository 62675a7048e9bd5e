#include "host/march/adaptive_march.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "host/run/run.hpp"
#include "tests/host/run/sample_cases.hpp"
#include "tests/host/run/solved_run.hpp"
#include "tests/test_folder.hpp"

// A run with every operation of an adaptive front and growing cracks: its bytes depend neither on threads and batch
// size nor on interruptions, and the device makes the same decisions as the host.
namespace tentpole {
namespace {

namespace fs = std::filesystem;

/// A short, coarse bar of the thesis (2.4.1) whose many defects give way where the waves meet.
const char* const spalling_bar = R"toml(
[domain]
dimension = 2
min = [0.0, 0.0]
max = [5e-4, 1e-4]
cells = [12, 3]
pattern = "unstructured"
[material.all]
density = 3690.0
youngs_modulus = 260e9
poisson_ratio = 0.21
[boundary.left]
normal_velocity = "6.1"
tangential_velocity = "0"
ramp = 4e-9
[boundary.right]
normal_velocity = "6.1"
tangential_velocity = "0"
ramp = 4e-9
[boundary.bottom]
normal_velocity = "0"
tangential_traction = "0"
[boundary.top]
normal_velocity = "0"
tangential_traction = "0"
[time]
end = 4e-8
[discretization]
degree = 2
[front]
smoothing = true
[adaptivity]
enabled = true
error_tolerance = 3e-5
min_size = 1.5e-5
max_size = 5e-5
[fracture]
enabled = true
threshold = 300e6
strength = 400e6
relaxation_time = 8e-9
friction = 0.3
[fracture.nucleation]
model = "field"
mean = 2.0e9
minimum = 220e6
maximum = 4.0e9
tail_strength = 400e6
tail_probability = 2e-4
density = 2e13
[output]
snapshots = 2
history_interval = 1e-9
fields = ["displacement", "stress", "damage"]
[[output.probe]]
name = "inside"
point = [2e-4, 5e-5]
)toml";

constexpr int no_limit = std::numeric_limits<int>::max();

/// How one part of a run goes: until the end, or interrupted after so many rounds.
struct Leg {
  Device device = host_device();
  int threads = 2;
  int batch_size = 64;
  int rounds = no_limit;
  bool resume = false;
};

RunResult run_leg(Simulation simulation, const fs::path& folder, const Leg& leg) {
  simulation.settings.batch_size = leg.batch_size;
  RunOptions options;
  options.device = leg.device;
  options.threads = leg.threads;
  options.folder = folder;
  options.check = true;
  if (leg.resume) options.resume = folder / "checkpoint.h5";
  options.interrupted = [left = leg.rounds]() mutable { return --left <= 0; };
  return run_simulation(simulation, options);
}

/// The run that others are compared with, solved once.
struct WholeRun {
  Simulation simulation = testing::simulation_of(spalling_bar);
  std::vector<std::pair<std::string, std::string>> files;
  RunSummary summary;
  int num_rounds = 0;

  WholeRun() {
    const fs::path folder = test_folder("whole");
    summary = run_leg(simulation, folder, {}).summary;
    num_rounds = static_cast<int>(summary.counts.batches);  // at least: a round of more than 64 patches takes two
    files = results_in(folder);
    fs::remove_all(folder);
  }
};

const WholeRun& whole_run() {
  static const WholeRun run;
  return run;
}

void expect_same_files(const fs::path& folder) {
  const auto found = results_in(folder);
  ASSERT_EQ(found.size(), whole_run().files.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_TRUE(found[i] == whole_run().files[i]) << found[i].first << " differs from " << whole_run().files[i].first;
}

TEST(SpallingBar, GoesThroughEveryOperation) {
  const RunSummary& summary = whole_run().summary;
  const RunSummary::Counts& counts = summary.counts;
  EXPECT_GT(counts.rejected, 0);
  EXPECT_GT(counts.splits, 0);
  EXPECT_GT(counts.deletions, 0);
  EXPECT_GT(counts.flips, 0);
  EXPECT_GT(counts.inclined, 0);
  EXPECT_GT(summary.fracture.nucleations, 0);
  EXPECT_GT(summary.fracture.extensions, 0);
  EXPECT_GT(summary.fracture.coalescences, 0);
  EXPECT_GT(summary.fracture.damage_max, 0.3);
  EXPECT_LE(summary.energy.largest_patch_imbalance, 1e-9);
  EXPECT_LE(std::fabs(summary.energy.balance_error()), 1e-9 * summary.energy.external_work);
  EXPECT_GT(summary.energy.fracture, 0);
  EXPECT_GE(summary.energy.friction, 0);
  ASSERT_GT(whole_run().num_rounds, 60) << "too few rounds to be interrupted";
}

TEST(SpallingBar, KeepsEveryByteWithOtherThreadsAndBatches) {
  for (const auto& [threads, batch_size] : {std::pair(1, 64), std::pair(2, 1), std::pair(1, 7), std::pair(2, 4096)}) {
    SCOPED_TRACE(std::to_string(threads) + " threads, batches of " + std::to_string(batch_size));
    const fs::path folder = test_folder("other");
    run_leg(whole_run().simulation, folder, {.threads = threads, .batch_size = batch_size});
    expect_same_files(folder);
  }
}

TEST(SpallingBar, ResumedIsTheUninterruptedRun) {
  const fs::path folder = test_folder("parts");
  const int part = whole_run().num_rounds / 3;
  ASSERT_TRUE(run_leg(whole_run().simulation, folder, {.rounds = part}).interrupted);
  ASSERT_TRUE(run_leg(whole_run().simulation, folder, {.threads = 1, .batch_size = 5, .rounds = part, .resume = true})
                  .interrupted)
      << "ends before";
  ASSERT_FALSE(run_leg(whole_run().simulation, folder, {.resume = true}).interrupted);
  expect_same_files(folder);
}

TEST(SpallingBar, ResumesOnlyWhereTheCrackFilesAre) {
  const fs::path folder = test_folder("parts");
  ASSERT_TRUE(run_leg(whole_run().simulation, folder, {.rounds = whole_run().num_rounds / 2}).interrupted);
  for (const char* name : {"cracks_0000.vtkhdf", "cracks.vtkhdf.series"}) {
    ASSERT_TRUE(fs::exists(folder / name)) << name;
    fs::rename(folder / name, folder / "away");
    try {
      run_leg(whole_run().simulation, folder, {.resume = true});
      ADD_FAILURE() << "goes on without " << name;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(std::string(name) + " is missing"), std::string::npos) << error.what();
    }
    fs::rename(folder / "away", folder / name);
  }
}

TEST(SpallingBar, InterruptedAfterEachOfManyRoundsIsTheUninterruptedRun) {
  const fs::path folder = test_folder("often");
  for (int round = 0; round < 20; ++round)
    ASSERT_TRUE(run_leg(whole_run().simulation, folder, {.rounds = 1, .resume = round > 0}).interrupted);
  // In the middle, where cracks grow, too.
  ASSERT_TRUE(
      run_leg(whole_run().simulation, folder, {.rounds = whole_run().num_rounds / 2, .resume = true}).interrupted);
  for (int round = 0; round < 20; ++round)
    ASSERT_TRUE(run_leg(whole_run().simulation, folder, {.rounds = 1, .resume = true}).interrupted);
  ASSERT_FALSE(run_leg(whole_run().simulation, folder, {.resume = true}).interrupted);
  expect_same_files(folder);
}

TEST(SpallingBar, GoesTheSameWayOnTheDevice) {
  const std::vector<Device> devices = testing::test_devices();
  if (devices.size() == 1) GTEST_SKIP() << "this build has no device";
  const fs::path folder = test_folder("device");
  const RunSummary found = run_leg(whole_run().simulation, folder, {.device = devices[1]}).summary,
                   expected = whole_run().summary;
  EXPECT_GT(found.traffic.launches, 0);
  const auto counts = [](const RunSummary& summary) {
    const RunSummary::Counts& c = summary.counts;
    const RunSummary::Fracture& f = summary.fracture;
    return std::vector<std::int64_t>{c.patches,     c.elements,   c.rejected, c.min_size_hits, c.splits,
                                     c.deletions,   c.flips,      c.inclined, c.cells_min,     c.cells_max,
                                     f.nucleations, f.extensions, f.branches, f.coalescences};
  };
  EXPECT_EQ(counts(found), counts(expected));
  const auto numbers = [](const RunSummary& summary) {
    const RunSummary::Energy& e = summary.energy;
    return std::vector<double>{e.external_work, e.kinetic, e.strain, e.fracture, e.friction, e.numerical};
  };
  double difference = 0;
  for (std::size_t i = 0; i < numbers(expected).size(); ++i)
    difference =
        std::max(difference, std::fabs(numbers(found)[i] - numbers(expected)[i]) / expected.energy.external_work);
  std::printf("  largest difference of an energy, relative to the work: %.1e\n", difference);
  EXPECT_LE(difference, 1e-9);
}

}  // namespace
}  // namespace tentpole
