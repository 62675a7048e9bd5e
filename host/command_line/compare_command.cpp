#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <utility>

#include "host/command_line/commands.hpp"
#include "host/command_line/interrupt.hpp"
#include "host/command_line/progress_bar.hpp"
#include "host/command_line/quantity.hpp"
#include "host/command_line/result_difference.hpp"
#include "host/command_line/result_folder.hpp"
#include "host/command_line/run_report.hpp"
#include "host/command_line/text_table.hpp"
#include "host/mesh/printable.hpp"
#include "host/run/run.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;

/// Rounding differs between devices and is amplified by the patch solves; anything larger is a fault.
constexpr double largest_accepted_difference = 1e-6;

/// A new folder for temporary files, removed with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "tentpole_compare_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error(name + ": cannot be created (" + std::strerror(errno) + "). Give a folder with --out.");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;  // a destructor cannot report it, and the folder is temporary
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

RunResult run_on(const Simulation& simulation, const Device& device, const CompareCommand& command,
                 const fs::path& folder, const Interrupt& interrupt) {
  RunOptions options;
  options.device = device;
  options.threads = choose_threads(command.input).threads;
  options.folder = folder;
  std::optional<PreparedFolder> prepared;
  options.prepare_folder = [&] {
    prepared.emplace(prepare_result_folder(folder));
    if (prepared->moved_aside)
      std::cerr << "note: the older result in " << printable(folder.string()) << " is now in "
                << printable(prepared->moved_aside->string()) << "\n";
    std::cout << "running on " << device.name << "\n" << std::flush;
  };
  options.require_folder = [&] { prepared->lock.require(); };
  ProgressBar progress(ProgressBar::style_of_stdout(command.quiet));
  options.report = [&](const Progress& now) { progress.update(now); };
  options.interrupted = [&] { return interrupt.requested(); };
  RunResult result = run_simulation(simulation, options);
  progress.finish();
  return result;
}

std::vector<std::pair<std::string, double>> stage_seconds(const RunSummary::Stages& stages) {
  return {{"initialization", stages.initialization.seconds},
          {"meshing", stages.meshing.seconds},
          {"assembly", stages.assembly.seconds},
          {"solution", stages.solution.seconds},
          {"post-solution", stages.post_solution.seconds},
          {"transfer", stages.transfer.seconds},
          {"fracture", stages.fracture.seconds},
          {"output", stages.output.seconds},
          {"total", stages.total.seconds}};
}

std::string comparison_text(const RunSummary& host, const RunSummary& device) {
  std::vector<std::vector<std::string>> rows{{"stage", "host", "device", "host / device"}};
  const auto host_stages = stage_seconds(host.stages), device_stages = stage_seconds(device.stages);
  for (std::size_t stage = 0; stage < host_stages.size(); ++stage) {
    const double a = host_stages[stage].second, b = device_stages[stage].second;
    rows.push_back({host_stages[stage].first, duration_text(a), duration_text(b), b > 0 ? short_number(a / b) : "-"});
  }
  const RunSummary::Traffic& traffic = device.traffic;
  return text_table(rows, "lrrr") + "traffic\n  " + bytes_text(static_cast<double>(traffic.bytes_to_device)) +
         " to the device, " + bytes_text(static_cast<double>(traffic.bytes_from_device)) + " back, " +
         count_text(traffic.launches) + " launches\n";
}

void print_difference(const ResultDifference& difference) {
  const std::string total = count_text(difference.num_values) + " numbers";
  std::cout << "largest relative difference of the solutions\n  ";
  if (difference.num_equal == difference.num_values)
    std::cout << "0: all " << total << " are the same bit for bit\n";
  else
    std::cout << short_number(difference.largest) << " (" << difference.where << "); "
              << count_text(difference.num_equal) << " of " << total << " are the same bit for bit\n";
  if (!(difference.largest <= largest_accepted_difference))
    throw std::runtime_error("host and device disagree by " + short_number(difference.largest) + " (" +
                             difference.where + "), more than rounding explains (" +
                             short_number(largest_accepted_difference) + ")");
}

}  // namespace

int compare_command(const CompareCommand& command) {
  outlive_failed_writes();
  const Simulation simulation = read_simulation(command.input);
  const Device device = choose_device(true, command.device);
  const Interrupt interrupt("\nfinishing the batch; a second Ctrl-C quits at once\n");
  std::optional<TemporaryFolder> temporary;
  const fs::path folder = command.out ? *command.out : temporary.emplace().path();
  std::cout << header_text(simulation, device, choose_threads(command.input));
  const RunResult on_host = run_on(simulation, host_device(), command, folder / "host", interrupt);
  if (on_host.interrupted) return 130;
  const RunResult on_device = run_on(simulation, device, command, folder / "device", interrupt);
  if (on_device.interrupted) return 130;
  std::cout << comparison_text(on_host.summary, on_device.summary);
  print_difference(compare_results(folder / "host", folder / "device"));
  return 0;
}

}  // namespace tentpole
