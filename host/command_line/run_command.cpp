#include <iostream>
#include <optional>

#include "host/command_line/commands.hpp"
#include "host/command_line/interrupt.hpp"
#include "host/command_line/progress_bar.hpp"
#include "host/command_line/quantity.hpp"
#include "host/command_line/result_folder.hpp"
#include "host/command_line/run_report.hpp"
#include "host/mesh/printable.hpp"
#include "host/run/run.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;

/// A resumed run goes on in the folder of its checkpoint, where its unfinished files are.
fs::path resumed_folder(const RunCommand& command) {
  const fs::path& checkpoint = *command.resume;
  if (!fs::is_regular_file(checkpoint))
    throw InputError("--resume: there is no checkpoint " + checkpoint.string() +
                     ". Give the checkpoint.h5 of an interrupted run.");
  const fs::path folder = checkpoint.has_parent_path() ? checkpoint.parent_path() : ".";
  if (command.out && !(fs::exists(*command.out) && fs::equivalent(*command.out, folder)))
    throw InputError("--out " + command.out->string() + ": a resumed run goes on in the folder of its checkpoint, " +
                     folder.string() + ". Leave out --out.");
  return folder;
}

fs::path result_folder(const RunCommand& command) {
  if (command.resume) return resumed_folder(command);
  return command.out ? *command.out : default_result_folder(command.input.case_file);
}

PreparedFolder ready_folder(const RunCommand& command, const fs::path& path) {
  if (command.resume) return reopen_result_folder(path);
  PreparedFolder folder = prepare_result_folder(path);
  if (folder.moved_aside)
    std::cerr << "note: the older result in " << printable(folder.path.string()) << " is now in "
              << printable(folder.moved_aside->string()) << "\n";
  return folder;
}

/// As a shell takes it; letters that a terminal must not see appear as escapes in $'..'.
std::string quoted(const std::string& text) {
  if (text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,") ==
      std::string::npos)
    return text;
  if (printable(text) != text) {
    std::string escaped;
    for (const char letter : text)
      escaped += letter == '\'' || letter == '\\' ? std::string("\\") + letter : std::string(1, letter);
    return "$'" + printable(escaped) + "'";
  }
  std::string result = "'";
  for (const char letter : text) result += letter == '\'' ? "'\\''" : std::string(1, letter);
  return result + "'";
}

/// The command that goes on from a checkpoint: the same case with the same changes.
std::string resuming_command(const RunCommand& command, const fs::path& checkpoint) {
  std::string text = "tentpole run " + quoted(command.input.case_file.string());
  for (const std::string& item : command.input.overrides) text += " --set " + quoted(item);
  if (command.input.seed) text += " --seed " + std::to_string(*command.input.seed);
  if (command.input.threads > 0) text += " --threads " + std::to_string(command.input.threads);
  if (command.device)
    text += " --device " + std::to_string(*command.device);
  else if (command.offload)
    text += " --offload";
  if (command.check) text += " --check";
  return text + " --resume " + quoted(checkpoint.string());
}

}  // namespace

int run_command(const RunCommand& command) {
  outlive_failed_writes();
  const Simulation simulation = read_simulation(command.input);
  RunOptions options;
  options.device = choose_device(command.offload, command.device);
  const ThreadChoice threads = choose_threads(command.input);
  options.threads = threads.threads;
  options.check = command.check;
  options.resume = command.resume;
  options.any_build = command.force;
  options.note = [](const std::string& text) { std::cerr << "note: " << printable_lines(text) << "\n"; };
  options.folder = result_folder(command);
  std::optional<PreparedFolder> folder;
  options.prepare_folder = [&] {
    folder.emplace(ready_folder(command, options.folder));
    if (!command.quiet) std::cout << header_text(simulation, options.device, threads) << std::flush;
  };
  options.require_folder = [&] { folder->lock.require(); };
  const Interrupt interrupt("\nfinishing the batch and writing a checkpoint; a second Ctrl-C quits at once\n");

  ProgressBar progress(ProgressBar::style_of_stdout(command.quiet));
  double front_time = 0;
  options.report = [&](const Progress& now) {
    front_time = now.front_time;
    progress.update(now);
  };
  options.interrupted = [&] { return interrupt.requested(); };
  const RunResult result = run_simulation(simulation, options);
  progress.finish();
  if (result.interrupted) {
    std::cerr << "interrupted at t = " << short_number(front_time) << " s; go on with:\n  "
              << resuming_command(command, result.checkpoint) << "\n";
    return 130;
  }
  if (!command.quiet) std::cout << summary_text(result.summary) << files_text(options.folder);
  return 0;
}

}  // namespace tentpole
