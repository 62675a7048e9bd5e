#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/host/run/solved_run.hpp"
#include "tests/host/run/wave_field.hpp"

// The tents and their solutions do not depend on the order of work, so results are the same bytes for any number of
// threads and any batch size; the device runs the same arithmetic with another compiler.
namespace tentpole {
namespace {

using testing::CaseText;
using testing::SideKind;
using testing::SolvedRun;

CaseText rich_case(int dimension) {
  CaseText text;
  text.dimension = dimension;
  text.degree = dimension == 3 ? 2 : 3;
  const int cells[4] = {0, 20, 5, 2};
  text.cells.assign(3, cells[dimension]);
  text.end = dimension == 3 ? 0.2 : 0.4;
  text.history_rows = 10;
  text.solid = testing::wave_solid(dimension);
  const std::vector<double> point(dimension, 0.4);
  text.rest = "[[output.probe]]\nname = \"inside\"\npoint = " + testing::number_list(point) + "\ninterval = 0.01\n" +
              field_sections(wave_field(testing::standard_waves(dimension), text.solid),
                             {SideKind::velocity, SideKind::traction, SideKind::roller, SideKind::slider,
                              SideKind::absorbing, SideKind::velocity});
  text.snapshots = 2;
  return text;
}

SolvedRun solve(CaseText text, const Device& device, int threads, int batch_size) {
  text.batch_size = batch_size;
  return testing::solve(text.text(), device, threads);
}

std::vector<double> numbers(const RunSummary& summary) {
  const RunSummary::Energy& energy = summary.energy;
  const RunSummary::Errors errors = summary.errors.value();
  return {energy.initial,
          energy.external_work,
          energy.kinetic,
          energy.strain,
          energy.numerical,
          errors.displacement_l2,
          errors.displacement_l2_relative,
          errors.energy_norm};
}

void expect_same_bytes(const SolvedRun& expected, const SolvedRun& found) {
  EXPECT_EQ(numbers(expected.summary), numbers(found.summary));
  EXPECT_EQ(expected.summary.counts.patches, found.summary.counts.patches);
  ASSERT_EQ(expected.files.size(), found.files.size());
  for (const auto& [name, bytes] : expected.files) EXPECT_TRUE(found.files.at(name) == bytes) << name << " differs";
}

class Reproducibility : public ::testing::TestWithParam<int> {};

TEST_P(Reproducibility, ThreadsAndBatchSizesLeaveEveryByteOfTheResults) {
  const CaseText text = rich_case(GetParam());
  for (const Device& device : testing::test_devices()) {
    const SolvedRun expected = solve(text, device, 1, 7);
    ASSERT_GE(expected.files.size(), 5u);  // history, probe, three snapshots
    for (const auto& [threads, batch_size] :
         {std::pair(2, 7), std::pair(2, 1), std::pair(1, 4096), std::pair(2, 4096)}) {
      SCOPED_TRACE(device.name + ", " + std::to_string(threads) + " threads, batches of " + std::to_string(batch_size));
      expect_same_bytes(expected, solve(text, device, threads, batch_size));
    }
  }
}

/// Largest difference of two tables, each column relative to its largest number; columns that are only rounding to the
/// largest number of the table.
double largest_difference(const testing::Table& expected, const testing::Table& found) {
  double difference = 0;
  for (const auto& [name, column] : expected) {
    double scale = 0;
    for (const double value : column) scale = std::max(scale, std::fabs(value));
    const std::vector<double>& other = found.at(name);
    EXPECT_EQ(column.size(), other.size()) << name;
    for (std::size_t row = 0; row < column.size(); ++row)
      difference =
          std::max(difference, scale > 0 ? std::fabs(other[row] - column[row]) / scale : std::fabs(other[row]));
  }
  return difference;
}

TEST_P(Reproducibility, TheDeviceAgreesWithTheHost) {
  const std::vector<Device> devices = testing::test_devices();
  if (devices.size() == 1) GTEST_SKIP() << "this build has no device";
  const SolvedRun host = solve(rich_case(GetParam()), devices[0], 2, 64);
  const SolvedRun device = solve(rich_case(GetParam()), devices[1], 2, 64);
  EXPECT_EQ(host.summary.traffic.launches, 0);
  EXPECT_GE(device.summary.traffic.launches, device.summary.counts.batches);
  double difference = 0;
  for (const char* name : {"history.csv", "probe_inside.csv"})
    difference = std::max(difference, largest_difference(testing::read_table(host.files.at(name)),
                                                         testing::read_table(device.files.at(name))));
  const std::vector<double> expected = numbers(host.summary), found = numbers(device.summary);
  for (std::size_t i = 0; i < expected.size(); ++i)
    difference = std::max(difference, std::fabs(found[i] / expected[i] - 1));
  std::printf("  D = %d: largest relative difference %.1e\n", GetParam(), difference);
  EXPECT_LE(difference, 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, Reproducibility, ::testing::Values(1, 2, 3));

}  // namespace
}  // namespace tentpole
