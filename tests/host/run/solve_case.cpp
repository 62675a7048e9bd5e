// solve_case CASE FOLDER MINUTES [BATCHES]: a run with checkpoints every so many minutes, for tests that kill it. After
// so many batches it gets 256 MiB more of addresses at most, and takes all memory that it can get.
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>

#include <sys/resource.h>
#include <unistd.h>

#include "host/run/make_simulation.hpp"
#include "host/run/run.hpp"

namespace {

[[noreturn]] void take_all_memory() {
  std::int64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t limit = pages * sysconf(_SC_PAGESIZE) + (rlim_t{256} << 20);
  const rlimit addresses{limit, limit};
  setrlimit(RLIMIT_AS, &addresses);
  // Written to, or a compiler may leave it out.
  while (true) *static_cast<volatile char*>(new char[1 << 20]) = 0;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace tentpole;
  if (argc != 4 && argc != 5) return 2;
  try {
    Simulation simulation = make_simulation(read_case(argv[1]));
    simulation.settings.checkpoint_minutes = std::atof(argv[3]);
    simulation.settings.batch_size = 4;
    RunOptions options;
    options.threads = 1;
    options.folder = argv[2];
    if (argc == 5)
      options.report = [left = std::atoi(argv[4])](const Progress&) mutable {
        if (--left == 0) take_all_memory();
      };
    run_simulation(simulation, options);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
