#include <cstdio>
#include <iostream>
#include <set>
#include <string>

#include "host/command_line/commands.hpp"
#include "host/many_core/read_machine.hpp"
#include "host/many_core/row_sweep.hpp"
#include "host/many_core/thread_list.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;

/// The folder of the machine files that come with the program: in the source tree the program is in build/PRESET,
/// installed it is in bin.
fs::path machine_folder() {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
  for (const char* place : {"../../device/machines", "../share/tentpole/machines"})
    if (fs::is_directory(program / place)) return (program / place).lexically_normal();
  return program;
}

std::string names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".toml") names.insert(entry.path().filename());
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// The path itself, or a machine file of that name that comes with the program.
fs::path find_machine_file(const fs::path& path) {
  if (fs::exists(path) || path.has_parent_path()) return path;
  const fs::path folder = machine_folder();
  if (fs::path found = folder / path; fs::is_regular_file(found)) return found;
  throw InputError(
      path.string() + ": is not a readable file, nor one that comes with the program (" + names_in(folder) +
      "). Give a path or one of these names; `tentpole devices --calibrate FILE` writes one for this machine.");
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
