#pragma once

#include <map>
#include <string>
#include <vector>

#include "device/device.hpp"
#include "host/output/run_summary.hpp"
#include "host/problem/simulation.hpp"

namespace tentpole::testing {

/// What a run in a temporary folder left.
struct SolvedRun {
  RunSummary summary;
  std::map<std::string, std::string> files;  ///< name and bytes of all results but summary.json
};

/// A table with a header line; columns by name.
using Table = std::map<std::string, std::vector<double>>;

/// The case file with this text as the solver sees it.
Simulation simulation_of(const std::string& case_text);

/// Solves with the balance of every patch checked.
SolvedRun solve(const Simulation& simulation, const Device& device = host_device(), int threads = 2);
SolvedRun solve(const std::string& case_text, const Device& device = host_device(), int threads = 2);

/// The host, and the device of builds that have one.
std::vector<Device> test_devices();

Table read_table(const std::string& csv);

/// Gives the cells whose centroid lies beyond `position` [m] in x a material of their own; it must not have faster
/// waves than the case's, which set the units.
void give_second_material(Simulation& simulation, double position, const Material& material);

}  // namespace tentpole::testing
