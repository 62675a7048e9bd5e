#include <fstream>

#include <gtest/gtest.h>

#include "host/case_file/case.hpp"
#include "host/run/make_simulation.hpp"
#include "host/run/run.hpp"
#include "tests/device/target_observer.hpp"
#include "tests/host/run/sample_cases.hpp"
#include "tests/test_folder.hpp"

namespace tentpole {
namespace {

/// A pulse between walls without load or body force, and output at the end only.
std::string quiet_case(int cells, double end) {
  const std::string n = std::to_string(cells), wall = "normal_velocity = \"0\"\ntangential_velocity = \"0\"\n";
  return "[domain]\ndimension = 2\nmin = [0.0, 0.0]\nmax = [1.0, 1.0]\ncells = [" + n + ", " + n +
         "]\n[material.all]\ndensity = 1.0\nyoungs_modulus = 2.5\npoisson_ratio = 0.25\n[boundary.left]\n" + wall +
         "[boundary.right]\n" + wall + "[boundary.bottom]\n" + wall + "[boundary.top]\n" + wall +
         "[initial]\ndisplacement = [\"exp(-20*(x-0.5)^2)\", \"0\"]\n[time]\nend = " + std::to_string(end) +
         "\n[discretization]\ndegree = 4\n[output]\nhistory_interval = " + std::to_string(end) + "\ntimes = [" +
         std::to_string(end) + "]\nfields = [\"displacement\"]\n";
}

RunSummary solve_on_device(const std::string& text, const std::string& name, const Device& device) {
  const std::filesystem::path folder = test_folder(name);
  std::ofstream(folder / "case.toml") << text;
  RunOptions options;
  options.device = device;
  options.folder = folder;
  return run_simulation(make_simulation(read_case(folder / "case.toml")), options).summary;
}

TEST(RunTraffic, ReportsExactlyWhatTheRuntimeMoved) {
  ASSERT_TRUE(is_observing()) << "run through ctest, or set LD_LIBRARY_PATH to the folder of libomp.so";
  const Device device = select_device(std::nullopt);
  const ObservedTraffic before = observed_traffic();
  const RunSummary summary = solve_on_device(quiet_case(6, 0.4), "run_traffic", device);
  const ObservedTraffic after = observed_traffic();
  EXPECT_EQ(summary.traffic.bytes_to_device, after.bytes_to_device - before.bytes_to_device);
  EXPECT_EQ(summary.traffic.bytes_from_device, after.bytes_from_device - before.bytes_from_device);
  EXPECT_EQ(summary.traffic.launches, after.launches - before.launches);
  EXPECT_GT(summary.traffic.launches, 0);
}

TEST(RunTraffic, NoMatrixCrossesTheBorder) {
  const Device device = select_device(std::nullopt);
  const RunSummary shorter = solve_on_device(quiet_case(8, 0.4), "shorter_run", device);
  const RunSummary longer = solve_on_device(quiet_case(8, 1.6), "longer_run", device);
  // Tables, first data and last output are the same in both runs; the difference is what the patches in between moved.
  const double elements = static_cast<double>(longer.counts.elements - shorter.counts.elements);
  const double up = (longer.traffic.bytes_to_device - shorter.traffic.bytes_to_device) / elements;
  const double down = (longer.traffic.bytes_from_device - shorter.traffic.bytes_from_device) / elements;
  const double matrix = 70.0 * 70.0 * 8;  // n = 70 for D = 2, k = 4
  RecordProperty("bytes_up_per_element", static_cast<int>(up));
  RecordProperty("bytes_down_per_element", static_cast<int>(down));
  EXPECT_LT(up, 400);
  EXPECT_LT(down, 100);
  EXPECT_LT(up + down, matrix / 50);
}

}  // namespace
}  // namespace tentpole
