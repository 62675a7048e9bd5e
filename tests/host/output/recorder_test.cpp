#include "host/output/recorder.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "host/output/output_times.hpp"
#include "tests/host/output/pitched_elements.hpp"
#include "tests/host/output/sample_fields.hpp"
#include "tests/temporary_folder.hpp"

namespace tentpole {
namespace {

RecorderOptions options_for(const PitchedBox& box, const std::filesystem::path& folder) {
  RecorderOptions options;
  options.dimension = box.dimension;
  options.degree = box.degree;
  options.folder = folder;
  options.snapshot_times = equally_spaced_times(3, box.end);
  options.fields = {"displacement", "velocity", "stress", "strain_energy_density", "damage"};
  options.probes = {{"corner", {0, 0, 0}, times_at_interval(box.end / 10, box.end)}};
  return options;
}

std::vector<std::size_t> shuffled(std::size_t count, unsigned seed) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  return order;
}

const char* const result_files[] = {"snapshot_0000.vtkhdf", "snapshot_0001.vtkhdf",   "snapshot_0002.vtkhdf",
                                    "snapshot_0003.vtkhdf", "snapshot.vtkhdf.series", "probe_corner.csv"};

void expect_equal_files(const TemporaryFolder& a, const TemporaryFolder& b) {
  for (const char* name : result_files) {
    EXPECT_FALSE(a.read(name).empty()) << name;
    EXPECT_TRUE(a.read(name) == b.read(name)) << name << " differs";
  }
}

TEST(Recorder, WritesTheSameBytesForAnyOrderOfElements) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    PitchedBox box;
    box.dimension = dimension;
    box.cells = {3, 3, 2};
    box.end = 3e-8;
    const PitchedElements pitched = pitch_elements(box, quadratic_field(dimension));
    TemporaryFolder straight, mixed;
    for (const auto& [folder, seed] : {std::pair{&straight, 1u}, std::pair{&mixed, 2u}}) {
      Recorder recorder(options_for(box, folder->path()));
      for (const std::size_t index : shuffled(pitched.elements.size(), seed)) {
        SpacetimeElement element = pitched.elements[index];
        element.id += 1000 * seed;  // running numbers differ between batch sizes
        recorder.record(element);
      }
      recorder.finish(box.end);
    }
    expect_equal_files(straight, mixed);
  }
}

TEST(Recorder, GoesOnBitwiseFromACheckpoint) {
  PitchedBox box;
  const PitchedElements pitched = pitch_elements(box, quadratic_field(2));
  const std::size_t half = pitched.elements.size() / 2;
  TemporaryFolder whole, resumed;
  const auto record = [&](Recorder& recorder, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) recorder.record(pitched.elements[i]);
  };
  double front = box.end;  // elements are in the order of their bottoms
  for (std::size_t i = half; i < pitched.elements.size(); ++i) front = std::min(front, pitched.elements[i].time_min());
  Recorder recorder(options_for(box, whole.path()));
  record(recorder, 0, pitched.elements.size());
  recorder.finish(box.end);

  std::stringstream checkpoint;
  {
    Recorder interrupted(options_for(box, resumed.path()));
    record(interrupted, 0, half);
    interrupted.finish(front);
    interrupted.save(checkpoint);
    record(interrupted, half, pitched.elements.size());
    interrupted.finish(box.end);  // rows after the checkpoint, which the resumed run must cut off
  }
  Recorder next(options_for(box, resumed.path()));
  next.load(checkpoint);
  record(next, half, pitched.elements.size());
  next.finish(box.end);
  expect_equal_files(whole, resumed);
}

TEST(Recorder, WantsExactlyTheElementsThatReachAnOutput) {
  PitchedBox box;
  TemporaryFolder folder;
  RecorderOptions options = options_for(box, folder.path());
  options.snapshot_times = {0, 5e-8};
  options.probes[0].times = {2e-8};
  const Recorder recorder(options);
  const std::array<double, 2> lower = {5e-4, 5e-4}, upper = {6e-4, 6e-4}, origin = {0, 0};
  EXPECT_TRUE(recorder.wants(0, 1e-9, lower, upper));
  EXPECT_TRUE(recorder.wants(4.9e-8, 5e-8, lower, upper));
  EXPECT_FALSE(recorder.wants(5e-8, 6e-8, lower, upper));
  EXPECT_FALSE(recorder.wants(1.9e-8, 2.1e-8, lower, upper));
  EXPECT_TRUE(recorder.wants(1.9e-8, 2.1e-8, origin, upper));
}

TEST(Recorder, WritesASnapshotOnlyWhenTheFrontHasPassed) {
  PitchedBox box;
  const PitchedElements pitched = pitch_elements(box, quadratic_field(2));
  TemporaryFolder folder;
  Recorder recorder(options_for(box, folder.path()));
  for (const SpacetimeElement& element : pitched.elements) recorder.record(element);
  recorder.finish(0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "snapshot_0000.vtkhdf"));
  recorder.finish(0.5 * box.end);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "snapshot_0001.vtkhdf"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "snapshot_0002.vtkhdf"));
}

TEST(Recorder, ProbeRowsFollowTheExactField) {
  PitchedBox box;
  const DisplacementField exact = quadratic_field(2);
  const PitchedElements pitched = pitch_elements(box, exact);
  TemporaryFolder folder;
  RecorderOptions options = options_for(box, folder.path());
  options.probes = {{"inner", {3.3e-4, 7.1e-4, 0}, times_at_interval(box.end / 7, box.end)}};
  Recorder recorder(options);
  for (const SpacetimeElement& element : pitched.elements) recorder.record(element);
  recorder.finish(box.end);
  std::istringstream text(folder.read("probe_inner.csv"));
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line, "time,ux,uy,vx,vy,sxx,syy,sxy");
  int num_rows = 0;
  double time = -1, ux = 0, uy = 0;
  for (char comma; std::getline(text, line); ++num_rows) {
    std::istringstream row(line);
    row >> time >> comma >> ux >> comma >> uy;
    EXPECT_EQ(time, options.probes[0].times[num_rows]);
    const std::array<double, 3> event = {3.3e-4, 7.1e-4, time};
    EXPECT_NEAR(ux, exact(event)[0], 1e-20);
    EXPECT_NEAR(uy, exact(event)[1], 1e-20);
  }
  EXPECT_EQ(num_rows, 8);
  EXPECT_EQ(time, box.end);
}

TEST(Recorder, NamesAProbeOutsideTheDomain) {
  PitchedBox box;
  const PitchedElements pitched = pitch_elements(box, quadratic_field(2));
  TemporaryFolder folder;
  RecorderOptions options = options_for(box, folder.path());
  options.probes[0].point = {2e-3, 0, 0};
  Recorder recorder(options);
  for (const SpacetimeElement& element : pitched.elements) recorder.record(element);
  try {
    recorder.finish(box.end);
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("probe \"corner\": the point (0.002, 0) m"), std::string::npos);
  }
}

TEST(Recorder, RefusesUnknownFieldsRepeatedNamesAndUnsortedTimes) {
  PitchedBox box;
  TemporaryFolder folder;
  const RecorderOptions good = options_for(box, folder.path());
  RecorderOptions options = good;
  options.fields = {"temperature"};
  EXPECT_THROW(Recorder{options}, std::invalid_argument);
  options = good;
  options.fields = {"velocity", "velocity"};
  EXPECT_THROW(Recorder{options}, std::invalid_argument);
  options = good;
  options.probes.push_back(options.probes[0]);
  EXPECT_THROW(Recorder{options}, std::invalid_argument);
  options = good;
  options.snapshot_times = {1e-9, 1e-9};
  EXPECT_THROW(Recorder{options}, std::invalid_argument);
  options = good;
  options.probes[0].name = "a/b";
  EXPECT_THROW(Recorder{options}, std::invalid_argument);
}

}  // namespace
}  // namespace tentpole
