#include "host/run/checkpoint.hpp"

#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host/output/checkpoint_file.hpp"
#include "host/output/machine_info.hpp"
#include "host/run/make_simulation.hpp"
#include "host/run/result_settings.hpp"
#include "host/run/run.hpp"
#include "tests/device/tested_device.hpp"
#include "tests/host/run/sample_cases.hpp"
#include "tests/test_folder.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;

Simulation simulation_of(const std::string& text, const fs::path& folder, std::vector<std::string> overrides = {}) {
  const fs::path file = folder.parent_path() / (folder.filename().string() + ".toml");
  std::ofstream(file) << text;
  const Simulation simulation = make_simulation(read_case(file, overrides));
  fs::remove(file);
  return simulation;
}

/// How one part of a run goes: until the end, or interrupted after so many batches.
struct Leg {
  Device device = host_device();
  int threads = 1;
  int batch_size = 8;
  int batches = std::numeric_limits<int>::max();
};

RunResult run_leg(Simulation simulation, const fs::path& folder, const Leg& leg, bool resume) {
  simulation.settings.batch_size = leg.batch_size;
  RunOptions options;
  options.device = leg.device;
  options.threads = leg.threads;
  options.folder = folder;
  if (resume) options.resume = folder / "checkpoint.h5";
  options.interrupted = [left = leg.batches]() mutable { return --left <= 0; };
  return run_simulation(simulation, options);
}

struct Variant {
  int dimension;
  bool on_target_device;
};

std::string name_of(const testing::TestParamInfo<Variant>& info) {
  return "D" + std::to_string(info.param.dimension) + (info.param.on_target_device ? "OnTargetDevice" : "OnHost");
}

class ResumedRun : public testing::TestWithParam<Variant> {
 protected:
  void SetUp() override {
    if (GetParam().on_target_device) {
      const std::optional<Device> device = tested_device();
      if (!device) GTEST_SKIP() << "this build has no target device";
      device_ = *device;
    }
    whole_ = test_folder("whole");
    simulation_ = simulation_of(sample_case(GetParam().dimension), whole_);
    const RunResult result = run_leg(simulation_, whole_, leg(8, 1), false);
    ASSERT_FALSE(result.interrupted);
    num_patches_ = static_cast<int>(result.summary.counts.patches);
    ASSERT_GT(num_patches_, 200) << "too few patches to be interrupted several times";
  }

  Leg leg(int batch_size, int threads, int batches = std::numeric_limits<int>::max()) const {
    return {device_, threads, batch_size, batches};
  }

  Device device_ = host_device();
  fs::path whole_;
  Simulation simulation_;
  int num_patches_ = 0;
};

TEST_P(ResumedRun, EndsBitwiseAsTheUninterruptedRun) {
  std::mt19937 random(GetParam().dimension);
  for (int repeat = 0; repeat < 3; ++repeat) {
    const fs::path folder = test_folder("parts");
    const int batches = 1 + static_cast<int>(random() % (num_patches_ / 10));
    const RunResult first = run_leg(simulation_, folder, leg(8, 1, batches), false);
    ASSERT_TRUE(first.interrupted);
    EXPECT_EQ(first.checkpoint, folder / "checkpoint.h5");
    EXPECT_FALSE(fs::exists(folder / "summary.json"));
    const RunResult second = run_leg(simulation_, folder, leg(8, 1), true);
    ASSERT_FALSE(second.interrupted);
    EXPECT_EQ(results_in(folder), results_in(whole_)) << "interrupted after " << batches << " batches";
  }
}

TEST_P(ResumedRun, MayBeInterruptedAgainAndUseOtherBatchesAndThreads) {
  std::mt19937 random(7 + GetParam().dimension);
  const fs::path folder = test_folder("parts");
  bool resume = false;
  int num_interruptions = 0;
  for (bool ended = false; !ended; resume = true) {
    const int batch_size = std::array{1, 3, 8, 50, 1000}[random() % 5];
    const int batches = 1 + static_cast<int>(random() % (1 + num_patches_ / (3 * batch_size)));
    ended =
        !run_leg(simulation_, folder, leg(batch_size, 1 + static_cast<int>(random() % 3), batches), resume).interrupted;
    num_interruptions += !ended;
  }
  EXPECT_GE(num_interruptions, 2);
  EXPECT_EQ(results_in(folder), results_in(whole_));
}

TEST_P(ResumedRun, IsTheSameWithCheckpointsAfterEveryBatch) {
  const fs::path folder = test_folder("often");
  Simulation often = simulation_;
  often.settings.checkpoint_minutes = 1e-12;
  EXPECT_FALSE(run_leg(often, folder, leg(40, 1), false).interrupted);
  EXPECT_EQ(results_in(folder), results_in(whole_)) << "also that no checkpoint is left at the end";
}

TEST_P(ResumedRun, GoesOnAfterAFailureBetweenBatches) {
  const fs::path folder = test_folder("failed");
  RunOptions options;
  options.device = device_;
  options.folder = folder;
  options.report = [left = 9](const Progress&) mutable {
    if (--left == 0) throw std::runtime_error("the terminal is gone");
  };
  Simulation failing = simulation_;
  failing.settings.batch_size = 5;
  try {
    run_simulation(failing, options);
    FAIL() << "the exception is lost";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("the terminal is gone"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find((folder / "checkpoint.h5").string()), std::string::npos) << error.what();
  }
  run_leg(simulation_, folder, leg(8, 1), true);
  EXPECT_EQ(results_in(folder), results_in(whole_)) << "tents on their way were not taken back properly";
}

INSTANTIATE_TEST_SUITE_P(, ResumedRun,
                         testing::Values(Variant{1, false}, Variant{2, false}, Variant{3, false}, Variant{1, true},
                                         Variant{2, true}, Variant{3, true}),
                         name_of);

/// The message of the InputError that resuming in `folder` meets.
std::string refusal(const Simulation& simulation, const fs::path& folder) {
  try {
    run_leg(simulation, folder, {}, true);
  } catch (const InputError& error) {
    return error.what();
  } catch (const std::runtime_error&) {
    return "failed";
  }
  return "resumed";
}

class RefusedCheckpoint : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = test_folder("run");
    text_ = sample_case(2);
    simulation_ = simulation_of(text_, folder_);
    for (bool resume = false; !fs::exists(folder_ / "snapshot_0000.vtkhdf"); resume = true)
      ASSERT_TRUE(run_leg(simulation_, folder_, {.batches = 20}, resume).interrupted);
  }

  fs::path folder_;
  std::string text_;
  Simulation simulation_;
};

TEST_F(RefusedCheckpoint, OfAnotherCaseNamesTheFirstDifference) {
  const auto with = [&](const std::string& override_text) {
    return refusal(simulation_of(text_, folder_, {override_text}), folder_);
  };
  EXPECT_NE(with("material.all.density=2800.0").find("material.all.density is 2700 there and 2800 here"),
            std::string::npos);
  EXPECT_NE(with("time.end=1.6e-4").find("time.end"), std::string::npos);
  EXPECT_NE(with("discretization.degree=3").find("discretization.degree is 2 there and 3 here"), std::string::npos);
  EXPECT_NE(with("domain.seed=2").find("domain.seed is 1 there and 2 here"), std::string::npos);
  EXPECT_NE(with("boundary.left.normal_traction=1e6*cos(x+t*1.001e4)").find("boundary.left"), std::string::npos);
  EXPECT_NE(with("boundary.left.tangential_velocity=y*y").find("boundary.left"), std::string::npos);
  EXPECT_NE(with("boundary.left.ramp=1e-5").find("boundary.left.ramp is 0 there and 1e-05 here"), std::string::npos);
  EXPECT_NE(with("body_force.acceleration=[\"0\",\"-9.8\"]").find("body_force.acceleration"), std::string::npos);
  EXPECT_NE(with("output.snapshots=5").find("output.snapshots"), std::string::npos);
  EXPECT_EQ(with("title=another name"), "resumed") << "what does not change the result may change";
}

TEST_F(RefusedCheckpoint, OfAnotherBuildNamesBothAndGoesOnWhenForced) {
  const fs::path whole = test_folder("whole");
  run_leg(simulation_, whole, {}, false);
  const fs::path file = folder_ / "checkpoint.h5";
  CheckpointContents contents = read_checkpoint_file(file);
  ASSERT_EQ(contents.builds, std::vector{build_identity()});
  const std::string other = "tentpole 0.0.9, sources 0123456789ab, g++ 4";
  contents.builds = {other};
  write_checkpoint_file(folder_, contents);
  const std::string message = refusal(simulation_, folder_);
  for (const std::string& part : {file.string(), other, build_identity(), std::string("--force")})
    EXPECT_NE(message.find(part), std::string::npos) << message;
  // Also when it is interrupted in between.
  RunOptions options;
  options.folder = folder_;
  options.resume = file;
  options.any_build = true;
  std::string note;
  options.note = [&](const std::string& text) { note = text; };
  options.interrupted = [] { return true; };
  ASSERT_TRUE(run_simulation(simulation_, options).interrupted);
  EXPECT_NE(note.find(other), std::string::npos) << note;
  EXPECT_EQ(read_checkpoint_file(file).builds, (std::vector{other, build_identity()}));
  options.any_build = false;
  options.interrupted = [] { return false; };
  const RunSummary summary = run_simulation(simulation_, options).summary;
  ASSERT_FALSE(summary.warnings.empty());
  EXPECT_NE(summary.warnings.back().find(other), std::string::npos) << summary.warnings.back();
  EXPECT_EQ(bytes_of(folder_ / "history.csv"), bytes_of(whole / "history.csv")) << "the builds are the same in truth";
}

void put_bytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

bool equal(const CheckpointContents& a, const CheckpointContents& b) {
  return a.builds == b.builds && a.settings == b.settings && a.front_times == b.front_times &&
         a.cell_element == b.cell_element && a.cell_facet == b.cell_facet && a.coefficients == b.coefficients &&
         a.inverse_jacobians == b.inverse_jacobians && a.ledger == b.ledger && a.recorder == b.recorder &&
         a.history == b.history && a.stage_seconds == b.stage_seconds && a.run_counts == b.run_counts;
}

TEST_F(RefusedCheckpoint, WithADamagedByteIsNeverReadAsAnotherState) {
  const fs::path file = folder_ / "checkpoint.h5";
  const std::string good = bytes_of(file);
  const CheckpointContents contents = read_checkpoint_file(file);
  std::mt19937 random(5);
  int num_refused = 0;
  for (int attempt = 0; attempt < 300; ++attempt) {
    std::string bad = good;
    bad[random() % bad.size()] ^= static_cast<char>(1 + random() % 255);
    put_bytes(file, bad);
    try {
      EXPECT_TRUE(equal(read_checkpoint_file(file), contents)) << "attempt " << attempt;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos);
      ++num_refused;
    }
  }
  EXPECT_GT(num_refused, 100) << "most bytes carry data";
}

TEST_F(RefusedCheckpoint, ThatIsTruncatedForeignOrMissing) {
  const fs::path file = folder_ / "checkpoint.h5";
  const std::string good = bytes_of(file);
  for (const std::string& bad :
       {std::string(), good.substr(0, 100), good.substr(0, good.size() - 1), std::string("text")}) {
    put_bytes(file, bad);
    EXPECT_NE(refusal(simulation_, folder_).find("is no checkpoint"), std::string::npos);
  }
  put_bytes(file, bytes_of(folder_ / "snapshot_0000.vtkhdf"));
  EXPECT_NE(refusal(simulation_, folder_).find("is no checkpoint"), std::string::npos) << "some other HDF5 file";
  fs::remove(file);
  EXPECT_NE(refusal(simulation_, folder_).find("is no checkpoint"), std::string::npos);
}

TEST_F(RefusedCheckpoint, WhoseOutputIsGoneAndTouchesNothing) {
  for (const char* name : {"history.csv", "snapshot_0000.vtkhdf", "snapshot.vtkhdf.series"}) {
    ASSERT_TRUE(fs::exists(folder_ / name)) << name;
    fs::rename(folder_ / name, folder_.parent_path() / "away");
    const auto before = results_in(folder_);
    const std::string message = refusal(simulation_, folder_);
    EXPECT_NE(message.find(std::string(name) + " is missing"), std::string::npos) << message;
    EXPECT_NE(message.find("Resume in the result folder"), std::string::npos) << message;
    EXPECT_EQ(results_in(folder_), before);
    fs::rename(folder_.parent_path() / "away", folder_ / name);
  }
  put_bytes(folder_ / "history.csv", "time");
  EXPECT_NE(refusal(simulation_, folder_).find("history.csv has 4 bytes of "), std::string::npos);
}

std::string bar_with_load(const std::string& load) {
  std::string text = sample_case(1);
  return text.replace(text.find("-sin(5*t)"), 9, load);
}

/// The error that ends a run in `folder` from t = 0.
std::string failure(const Simulation& simulation, const fs::path& folder) {
  try {
    run_leg(simulation, folder, {}, false);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no failure";
}

TEST(FailedRun, LeavesTheStateBeforeTheFaultInACheckpointAndSaysWhere) {
  const fs::path whole = test_folder("whole");
  const Simulation sound = simulation_of(bar_with_load("t"), whole);
  run_leg(sound, whole, {}, false);
  // The first is found while a batch is pitched, the second, whose equations overflow, while one is solved, the third,
  // whose energies overflow, after that.
  for (const std::string fault : {"sqrt(0.4-t)", "1e308", "1e200"}) {
    const fs::path folder = test_folder("failed");
    const Simulation faulty = simulation_of(bar_with_load("t < 0.4 ? t : " + fault), folder);
    const std::string message = failure(faulty, folder);
    EXPECT_NE(message.find((folder / "checkpoint.h5").string()), std::string::npos) << message;
    EXPECT_FALSE(fs::exists(folder / "summary.json"));
    EXPECT_TRUE(fs::exists(folder / "snapshot_0000.vtkhdf")) << "the state at t = 0.14";
    EXPECT_EQ(refusal(faulty, folder), fault.starts_with("1e") ? "failed" : message) << "the same fault comes again";
    // Until the fault both loads are the same, so with the settings of the sound run the checkpoint is one of it.
    CheckpointContents contents = read_checkpoint_file(folder / "checkpoint.h5");
    contents.settings = result_settings(sound);
    write_checkpoint_file(folder, contents);
    run_leg(sound, folder, {}, true);
    EXPECT_EQ(results_in(folder), results_in(whole)) << fault;
  }
}

// The callback leaks until the system refuses, so all that a checkpoint takes comes from the reserve.
TEST(RunWithoutMemory, LeavesACheckpointAndSaysWhatWasWanted) {
#ifdef TENTPOLE_ADDRESS_SANITIZER
  GTEST_SKIP() << "the address sanitizer ends a program whose memory is limited";
#endif
  const fs::path whole = test_folder("whole"), folder = test_folder("starved");
  const fs::path case_file = whole.parent_path() / "starved_run_case.toml";
  const Simulation simulation = simulation_of(sample_case(2), whole);
  run_leg(simulation, whole, {}, false);
  std::ofstream(case_file) << sample_case(2);
  const fs::path errors = folder.parent_path() / "starved_run_errors.txt";
  const std::string command = std::string(TENTPOLE_SOLVE_CASE) + " '" + case_file.string() + "' '" + folder.string() +
                              "' 1e9 9 2> '" + errors.string() + "'";
  const int status = std::system(command.c_str());
  const std::string message = bytes_of(errors);
  ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1) << status << " " << message;
  for (const std::string& part : {std::string("out of memory: 1 MiB were asked for, "), std::string(" are free"),
                                  (folder / "checkpoint.h5").string()})
    EXPECT_NE(message.find(part), std::string::npos) << message;
  run_leg(simulation, folder, {}, true);
  EXPECT_EQ(results_in(folder), results_in(whole));
}

TEST(Checkpoint, ThatCannotBeWrittenEndsTheRunWithAMessage) {
  const fs::path folder = test_folder("run");
  fs::create_directories(folder / "checkpoint.h5" / "in the way");
  const Simulation simulation = simulation_of(sample_case(1), folder);
  try {
    run_leg(simulation, folder, {.batches = 5}, false);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("checkpoint.h5: the checkpoint cannot be written"), std::string::npos);
  }
  EXPECT_FALSE(fs::exists(folder / ".checkpoint.h5.partial"));
}

/// Starts solve_case and kills it after the given time; false if it had ended before.
bool run_and_kill(const fs::path& case_file, const fs::path& folder, std::chrono::milliseconds delay) {
  const pid_t child = fork();
  if (child == 0) {
    execl(TENTPOLE_SOLVE_CASE, "solve_case", case_file.c_str(), folder.c_str(), "1e-9", nullptr);
    _exit(127);
  }
  while (!fs::exists(folder / "checkpoint.h5") && waitpid(child, nullptr, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::this_thread::sleep_for(delay);
  kill(child, SIGKILL);
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFSIGNALED(status);
}

TEST(KilledRun, LeavesACheckpointThatResumesToTheSameResult) {
  const fs::path whole = test_folder("whole");
  const Simulation simulation = simulation_of(sample_case(2), whole);
  run_leg(simulation, whole, {}, false);
  const fs::path case_file = whole.parent_path() / "killed_run_case.toml";
  std::ofstream(case_file) << sample_case(2);
  int num_killed = 0;
  for (int attempt = 0; attempt < 6; ++attempt) {
    const fs::path folder = test_folder("killed");
    if (!run_and_kill(case_file, folder, std::chrono::milliseconds(23 * attempt))) continue;
    ++num_killed;
    run_leg(simulation, folder, {}, true);
    EXPECT_EQ(results_in(folder), results_in(whole)) << "killed at attempt " << attempt;
  }
  EXPECT_GE(num_killed, 2) << "the run ends before it can be killed";
}

TEST(Checkpoint, CarriesTimesTrafficAndFallbacksOn) {
  const fs::path folder = test_folder("run");
  const Simulation simulation = simulation_of(sample_case(1), folder);
  ASSERT_TRUE(run_leg(simulation, folder, {.batches = 5}, false).interrupted);
  CheckpointContents contents = read_checkpoint_file(folder / "checkpoint.h5");
  EXPECT_GT(contents.stage_seconds[static_cast<int>(Stage::total)], 0);
  contents.stage_seconds[static_cast<int>(Stage::total)] = 1000;
  contents.run_counts = {1 << 20, 1 << 21, 1 << 22, 7};
  write_checkpoint_file(folder, contents);
  const RunSummary summary = run_leg(simulation, folder, {}, true).summary;
  EXPECT_GT(summary.stages.total.seconds, 1000);
  EXPECT_LT(summary.stages.total.seconds, 1100);
  EXPECT_EQ(summary.traffic.bytes_to_device, 1 << 20) << "the host itself moves nothing";
  EXPECT_EQ(summary.traffic.bytes_from_device, 1 << 21);
  EXPECT_EQ(summary.traffic.launches, 1 << 22);
  EXPECT_EQ(summary.counts.dense_fallbacks, 7);
}

TEST(Checkpoint, IsAsLargeAsTheFrontNotAsTheRun) {
  const fs::path folder = test_folder("run");
  const std::string text = sample_case(1);
  const Simulation simulation = simulation_of(text, folder, {"output.snapshots=0"});
  for (const int batches : {40, 100}) {
    ASSERT_TRUE(run_leg(simulation, folder, {.batch_size = 4, .batches = batches}, false).interrupted);
    const CheckpointContents contents = read_checkpoint_file(folder / "checkpoint.h5");
    const std::size_t cells = 60, basis = 15;  // C(4 + 2, 2)
    EXPECT_EQ(contents.coefficients.size(), cells * basis);
    EXPECT_EQ(contents.inverse_jacobians.size(), cells * 4);
  }
}

}  // namespace
}  // namespace tentpole
