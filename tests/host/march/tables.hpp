#pragma once

#include <string>

#include "tests/host/run/solved_run.hpp"

namespace tentpole::testing {

/// The table in a file of the run.
Table table_of(const SolvedRun& run, const std::string& file);

/// Largest difference of two tables, each column relative to its largest number.
double largest_difference(const Table& expected, const Table& found);

}  // namespace tentpole::testing
