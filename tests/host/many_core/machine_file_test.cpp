#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "host/case_file/input_error.hpp"
#include "host/many_core/read_machine.hpp"
#include "host/many_core/write_machine.hpp"
#include "tests/temporary_folder.hpp"

namespace tentpole {
namespace {

/// A machine file in a folder of its own.
class MachineFile {
 public:
  explicit MachineFile(const std::string& text) : path_(folder_.write("machine.toml", text)) {}
  const std::filesystem::path& path() const { return path_; }

 private:
  TemporaryFolder folder_;
  std::filesystem::path path_;
};

Machine sample_machine() {
  Machine machine;
  machine.name = "a \"quoted\" \\ name";
  machine.cores = {61, 1, 4, 8, 1.3e-8};
  machine.cache = {557056, 8.2e9, 1.6e11};
  machine.translation = {64, 4096, 8.3e-7};
  machine.fork_join = {7.85e-5, 1.57e-7, 1e-7, 1e-5};
  machine.loop = {false, {0, 0.5}};
  return machine;
}

std::string sample_text() {
  return machine_text(sample_machine(), "A sample.");
}

std::string with(std::string text, const std::string& line, const std::string& replacement) {
  const auto start = text.find(line);
  EXPECT_NE(start, std::string::npos) << line;
  return text.replace(start, text.find('\n', start) - start, replacement);
}

void expect_refused(const std::string& text, const std::string& fragment, std::size_t num_problems = 1) {
  const MachineFile file(text);
  try {
    read_machine(file.path());
    ADD_FAILURE() << "accepted, but should say: " << fragment;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos) << error.what();
    EXPECT_EQ(error.problems().size(), num_problems) << error.what();  // a misspelt key is missing as well
  }
}

TEST(MachineFile, WrittenFileReadsBack) {
  const MachineFile file(sample_text());
  const Machine machine = read_machine(file.path()), expected = sample_machine();
  EXPECT_EQ(machine_text(machine, "A sample."), sample_text());
  EXPECT_EQ(machine.name, expected.name);
  EXPECT_EQ(machine.usable_cores(), 60);
  EXPECT_EQ(machine.cache.shared_bandwidth, expected.cache.shared_bandwidth);
  EXPECT_EQ(machine.loop.added, expected.loop.added);
  EXPECT_FALSE(machine.loop.keeps_matrix);
}

TEST(MachineFile, FaultsHaveLineKeyValueAndWayOut) {
  const std::string text = sample_text();
  expect_refused(with(text, "count = ", "count = 0"), ".toml:6: cores.count = 0: must lie in [1, 1048576]. Give");
  expect_refused(with(text, "count = ", "count = 4.5"), "cores.count = 4.5: is a number. Give an integer.");
  expect_refused(with(text, "count = ", ""), "cores.count: missing. Give the number of cores.");
  expect_refused(with(text, "system = ", "system = 61"), "cores.system = 61: leaves no core to work. Give less than");
  expect_refused(with(text, "vector_time = ", "vector_time = 0"), "cores.vector_time = 0: must be positive.");
  expect_refused(with(text, "core_bandwidth = ", "core_bandwidth = -1"), "cache.core_bandwidth = -1: must lie in (0,");
  expect_refused(with(text, "walk_time = ", "walk_time = nan"), "translation.walk_time = nan: must be finite");
  expect_refused(with(text, "walk_time = ", "walk_tiem = 0"), "translation.walk_tiem = 0: unknown key. Did you mean",
                 2);
  expect_refused(with(text, "fixed = ", "fixed = \"1 us\""), "fork_join.fixed = \"1 us\": is a string. Give a number.");
  expect_refused(with(text, "keeps_matrix = ", "keeps_matrix = 1"), "loop.keeps_matrix = 1: is an integer. Give true");
  expect_refused(with(text, "added = ", "added = []"), "loop.added = []: must have 1 to 100 entries.");
  expect_refused(with(text, "added = ", "added = [2.0]"), "loop.added[1] = 2.0: must lie in [0, 1].");
  expect_refused(with(text, "name = ", ""), "name: missing. Give a string in quotes.");
  expect_refused("cache = 1\n" + text.substr(0, text.find("[cache]")) + text.substr(text.find("[translation]")),
                 ":1: cache = 1: is an integer. Write [cache] with its keys below.");
  expect_refused(text.substr(0, text.find("[loop]")), "loop: missing. Write [loop] with");
  expect_refused("[cores\n", "this is not TOML");
}

TEST(MachineFile, MissingFileIsRefused) {
  EXPECT_THROW(read_machine("no_such_machine.toml"), InputError);
}

TEST(MachineFile, ShippedFilesAreAccepted) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(TENTPOLE_MACHINES)) {
    EXPECT_FALSE(read_machine(entry.path()).name.empty());
    ++count;
  }
  EXPECT_EQ(count, 2);
}

}  // namespace
}  // namespace tentpole
