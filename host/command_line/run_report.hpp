#pragma once

#include <filesystem>
#include <string>

#include "device/device.hpp"
#include "device/thread_choice.hpp"
#include "host/output/run_summary.hpp"
#include "host/problem/simulation.hpp"

namespace tentpole {

/// Texts that `run`, `check` and `compare` print.

/// "triangles", after the dimension.
std::string cell_kind_text(int dimension);

/// Title, mesh, unknowns, end time and device with its threads, one line each.
std::string header_text(const Simulation& simulation, const Device& device, const ThreadChoice& choice);

/// Counts, time per stage with its share, energies with their balance, errors and traffic where there are any.
std::string summary_text(const RunSummary& summary);

/// Files of a result folder, one line each, and what to do with them.
std::string files_text(const std::filesystem::path& folder);

}  // namespace tentpole
