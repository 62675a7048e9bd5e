#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>
#include <hdf5.h>

#include "common/exact_sum.hpp"
#include "host/case_file/input_error.hpp"
#include "host/output/checkpoint_file.hpp"
#include "host/run/make_simulation.hpp"
#include "host/run/run.hpp"
#include "tests/host/run/sample_cases.hpp"
#include "tests/test_folder.hpp"

// Checkpoints that no run wrote, with checksums that fit: refused with the file, the section and what is wrong.
namespace tentpole {
namespace {

namespace fs = std::filesystem;

class CraftedCheckpoint : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    folder_ = test_folder("run");
    std::ofstream(folder_ / "case.toml") << sample_case(GetParam());
    simulation_ = make_simulation(read_case(folder_ / "case.toml"));
    simulation_.settings.batch_size = 8;
    RunOptions options;
    options.folder = folder_;
    options.threads = 1;
    options.interrupted = [left = 20]() mutable { return --left <= 0; };
    ASSERT_TRUE(run_simulation(simulation_, options).interrupted);
    good_ = read_checkpoint_file(file());
  }

  fs::path file() const { return folder_ / "checkpoint.h5"; }

  /// The message with which the file is refused, or how the run ends otherwise.
  std::string outcome() const {
    RunOptions options;
    options.folder = folder_;
    options.threads = 1;
    options.resume = file();
    options.interrupted = [] { return true; };
    try {
      run_simulation(simulation_, options);
    } catch (const InputError& error) {
      return error.what();
    } catch (const std::runtime_error& error) {
      return std::string("failed: ") + error.what();
    }
    return "resumed";
  }
  std::string outcome_of(const CheckpointContents& contents) const {
    write_checkpoint_file(folder_, contents);
    return outcome();
  }
  void expect_refused(const CheckpointContents& contents, const std::vector<std::string>& parts) const {
    const std::string message = outcome_of(contents);
    EXPECT_NE(message.find(file().string()), std::string::npos) << message;
    for (const std::string& part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
  }

  fs::path folder_;
  Simulation simulation_;
  CheckpointContents good_;
};

TEST_P(CraftedCheckpoint, WithANumberOutOfItsRangeSaysWhichSection) {
  CheckpointContents bad = good_;
  bad.cell_element[3] = 2000000000;
  expect_refused(bad, {"cell 3 lies on element 2000000000"});
  bad = good_;
  bad.cell_facet[2] = -5;
  expect_refused(bad, {"cell 2 is facet -5"});
  bad = good_;
  bad.cell_element.pop_back();
  expect_refused(bad, {"\"cell_element\""});
  bad = good_;
  bad.front_times[0] = std::nan("");
  expect_refused(bad, {"\"march\"", "vertex 0"});
  bad = good_;
  bad.coefficients.back() = std::numeric_limits<double>::infinity();
  expect_refused(bad, {"\"coefficients\"", "not finite"});
  bad = good_;
  bad.stage_seconds[0] = 1e300;
  expect_refused(bad, {"\"stage_seconds\""});
  bad = good_;
  bad.run_counts[1] = -1;
  expect_refused(bad, {"\"run_counts\""});
  EXPECT_EQ(outcome_of(good_), "resumed");
}

TEST_P(CraftedCheckpoint, WithALengthBeyondItsEndIsRefusedBeforeMemoryIsTaken) {
  CheckpointContents bad = good_;
  // bytes of the table, rows written, four sums of flows, four counts of events; then the rows of the history
  const std::size_t place = sizeof(std::int64_t) + sizeof(int) + 4 * sizeof(ExactSum) + 4 * sizeof(std::int64_t);
  std::int64_t length = 0;
  std::memcpy(&length, &bad.history[place], sizeof length);
  ASSERT_GT(length, 1) << "the place of the length";
  length = std::int64_t{1} << 61;
  std::memcpy(&bad.history[place], &length, sizeof length);
  expect_refused(bad, {"\"history\"", "byte ", "a list of 2305843009213693952 entries", "bytes are left"});
  bad = good_;
  bad.ledger.resize(10);
  expect_refused(bad, {"\"ledger\"", "byte 8: 8 bytes are needed and 2 are left"});
  bad = good_;
  bad.recorder += '\0';
  expect_refused(bad, {"\"recorder\"", "bytes are left over"});
}

TEST_P(CraftedCheckpoint, WithADataSetLargerThanTheFileIsRefusedBeforeMemoryIsTaken) {
  {
    const hid_t handle = H5Fopen(file().c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    H5Ldelete(handle, "coefficients", H5P_DEFAULT);
    const hsize_t extent = hsize_t{1} << 44, chunk = 1 << 10;
    const hid_t space = H5Screate_simple(1, &extent, nullptr), properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(properties, 1, &chunk);
    H5Pset_fletcher32(properties);
    const hid_t dataset =
        H5Dcreate2(handle, "coefficients", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    ASSERT_GE(dataset, 0);
    H5Dclose(dataset), H5Pclose(properties), H5Sclose(space), H5Fclose(handle);
  }
  const std::string message = outcome();
  for (const std::string& part : {file().string(), std::string("coefficients has 17592186044416 entries, more than")})
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(Dimensions, CraftedCheckpoint, testing::Values(1, 2));

}  // namespace
}  // namespace tentpole
