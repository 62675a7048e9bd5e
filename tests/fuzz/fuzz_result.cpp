#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "host/case_file/input_error.hpp"
#include "host/command_line/commands.hpp"
#include "host/command_line/quiet_hdf5.hpp"
#include "host/command_line/result_difference.hpp"
#include "tests/temporary_folder.hpp"

// Files of a result as `tentpole info` and `tentpole compare` read them. The first byte says which the other bytes are:
// 0 history.csv, 1 summary.json, 2 a snapshot, 3 a checkpoint, 4 history.csv of one of two results. They are described
// or refused with a message.
namespace tentpole {
namespace {

namespace fs = std::filesystem;

const fs::path& folder() {
  static const TemporaryFolder made;
  static const bool is_filled = [] {
    keep_hdf5_quiet();
    for (const char* part : {"described", "first", "second"}) fs::create_directories(made.path() / part);
    std::ofstream(made.path() / "second" / "history.csv") << "time,kinetic\n0,1\n1,2\n";
    return true;
  }();
  if (!is_filled) std::abort();
  return made.path();
}

void describe(int kind, const std::string& bytes) {
  static const char* const names[] = {"history.csv", "summary.json", "snapshot_0000.vtkhdf", "checkpoint.h5"};
  const fs::path file = kind == 4 ? folder() / "first" / "history.csv" : folder() / "described" / names[kind];
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  if (kind == 4)
    compare_results(folder() / "first", folder() / "second");
  else
    info_command(file);
}

}  // namespace
}  // namespace tentpole

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  std::ostringstream printed;
  std::streambuf* const terminal = std::cout.rdbuf(printed.rdbuf());
  try {
    tentpole::describe(data[0] % 5, std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  } catch (const std::runtime_error& error) {
    if (error.what()[0] == '\0') std::abort();
  }
  std::cout.rdbuf(terminal);
  return 0;
}
