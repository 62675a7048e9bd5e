#include <cstdio>
#include <iostream>
#include <string>

#include "host/command_line/commands.hpp"
#include "host/many_core/read_machine.hpp"
#include "host/many_core/row_sweep.hpp"
#include "host/many_core/thread_list.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;

/// The path itself, or a machine file of that name that comes with the program: in the source tree the program is in
/// build/PRESET, installed it is in bin.
fs::path find_machine_file(const fs::path& path) {
  if (fs::exists(path) || path.has_parent_path()) return path;
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  for (const char* place : {"../../device/machines", "../share/tentpole/machines"})
    if (fs::path found = folder / place / path; fs::is_regular_file(found)) return found.lexically_normal();
  return path;
}

std::string csv_row(const SweepPoint& point) {
  char text[160];
  std::snprintf(text, sizeof text, "%d,%.9g,%.6g,%.6g,%.6g\n", point.threads, point.time, point.speedup,
                point.efficiency, point.imbalance);
  return text;
}

}  // namespace

int model_command(const ModelCommand& command) {
  if (command.rows < 1 || command.rows > max_model_rows)
    throw InputError("--rows " + std::to_string(command.rows) + ": must lie in [1, " + std::to_string(max_model_rows) +
                     "]. Give the size of the cell matrix, e.g. 990.");
  const Machine machine = read_machine(find_machine_file(command.machine_file));
  const std::vector<int> threads =
      parse_thread_list(command.threads ? *command.threads : "1-" + std::to_string(2 * machine.usable_cores()));
  std::cout << "threads,time,speedup,efficiency,imbalance\n";
  for (const SweepPoint& point : model_sweep(machine, command.rows, threads)) std::cout << csv_row(point);
  return 0;
}

}  // namespace tentpole
