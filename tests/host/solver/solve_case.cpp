// solve_case CASE FOLDER MINUTES: a run with checkpoints every so many minutes, for tests that kill it.
#include <cstdlib>
#include <exception>
#include <iostream>

#include "host/solver/run.hpp"

int main(int argc, char** argv) {
  using namespace tentpole;
  if (argc != 4) return 2;
  try {
    Simulation simulation = make_simulation(read_case(argv[1]));
    simulation.settings.checkpoint_minutes = std::atof(argv[3]);
    simulation.settings.batch_size = 4;
    RunOptions options;
    options.threads = 1;
    options.folder = argv[2];
    run_simulation(simulation, options);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
