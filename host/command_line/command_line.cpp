#include "host/command_line/command_line.hpp"

#include <iostream>
#include <new>

#include <CLI/CLI.hpp>

#include "host/case_file/input_error.hpp"
#include "host/case_file/nearest_name.hpp"
#include "host/command_line/commands.hpp"
#include "host/command_line/prepare_hdf5.hpp"
#include "host/mesh/mesh_error.hpp"
#include "host/mesh/printable.hpp"
#include "host/output/machine_info.hpp"
#include "host/run/out_of_memory.hpp"

namespace tentpole {
namespace {

constexpr int failed = 1, bad_input = 2;

/// What all commands put together may be given.
struct Arguments {
  RunCommand run;
  CompareCommand compare;
  CheckCommand check;
  std::filesystem::path described;
  ModelCommand model;
  std::optional<std::filesystem::path> calibrate;
};

void add_case_options(CLI::App& command, CaseOptions& input) {
  command.add_option("CASE", input.case_file, "case file (docs/case-file.md)")->required()->type_name("");
  command.add_option("--set", input.overrides, "replace a value of the case file, e.g. --set discretization.degree=3")
      ->type_name("KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  command.add_option("--seed", input.seed, "seed of an unstructured mesh and of the defects of nucleation")
      ->type_name("N");
  command.add_option("--threads", input.threads, "number of threads (default: as many as cores)")
      ->type_name("N")
      ->check(CLI::Range(1, 4096).description(""));
}

void add_device_option(CLI::App& command, std::optional<int>& device, const std::string& description) {
  command.add_option("--device", device, description)->type_name("N");
}

void add_offload_options(CLI::App& command, bool& offload, std::optional<int>& device) {
  command.add_flag("--offload", offload, "solve on an OpenMP device: a GPU, or else the virtual device");
  add_device_option(command, device, "the device with this number in `tentpole devices`; implies --offload");
}

void add_run(CLI::App& app, RunCommand& command) {
  CLI::App* run = app.add_subcommand("run", "solve a case and write its result folder");
  add_case_options(*run, command.input);
  run->add_option("--out", command.out, "result folder (default: result_CASE); an older one is moved to DIR.1")
      ->type_name("DIR");
  CLI::Option* resume =
      run->add_option("--resume", command.resume, "go on from a checkpoint, in its folder")->type_name("FILE");
  run->add_flag("--force", command.force, "resume also from a checkpoint that another build of the program wrote")
      ->needs(resume);
  add_offload_options(*run, command.offload, command.device);
  run->add_flag("--check", command.check, "verify the energy balance of every patch");
  run->add_flag("--quiet", command.quiet, "print notes, warnings and errors only");
}

void add_check(CLI::App& app, CheckCommand& command) {
  CLI::App* check = app.add_subcommand("check", "validate a case and say what would run");
  add_case_options(*check, command.input);
  add_offload_options(*check, command.offload, command.device);
}

void add_compare(CLI::App& app, CompareCommand& command) {
  CLI::App* compare = app.add_subcommand("compare", "solve a case on host and device, compare times and solutions");
  add_case_options(*compare, command.input);
  compare->add_option("--out", command.out, "keep the results in DIR/host and DIR/device")->type_name("DIR");
  add_device_option(*compare, command.device, "the device with this number in `tentpole devices`");
  compare->add_flag("--quiet", command.quiet, "no progress bar");
}

void add_devices(CLI::App& app, Arguments& arguments) {
  app.add_subcommand("devices", "list the devices of the OpenMP runtime, with measured copy rates and launch costs")
      ->add_option_function<std::string>(
          "--calibrate", [&arguments](const std::string& file) { arguments.calibrate = file; },
          "measure this machine for `tentpole model` and write its machine file (default: machine.toml)")
      ->type_name("FILE")
      ->expected(0, 1)
      ->default_str("machine.toml");
}

void add_model(CLI::App& app, ModelCommand& command) {
  CLI::App* model = app.add_subcommand("model", "modelled sweep of threads on a machine with many cores, as CSV");
  model->add_option("MACHINE", command.machine_file, "machine file, or the name of one in device/machines")
      ->required()
      ->type_name("");
  model->add_option("--rows", command.rows, "size of the cell matrix (default: 990)")->type_name("N");
  model->add_option("--threads", command.threads, "e.g. 1-120 or 1,2,4-8 (default: 1 to twice the cores)")
      ->type_name("LIST");
}

/// A command whose arguments are not looked at here.
CLI::App* add_passing_command(CLI::App& app, const std::string& name, const std::string& description) {
  CLI::App* command = app.add_subcommand(name, description);
  command->set_help_flag();
  command->prefix_command();
  return command;
}

std::string version_text() {
  const BuildInfo build = build_info();
  return "tentpole " + build.version + " (" + build.git_revision + ", " + build.compiler + ", " + build.architecture +
         ")";
}

std::string failure_text(const CLI::App* app, const CLI::Error& error) {
  std::string command = app->get_name();
  for (const CLI::App* chosen : app->get_subcommands()) command += " " + chosen->get_name();
  return command + ": " + printable(error.what()) + "\n`" + command + " --help` lists what is allowed.\n";
}

void describe_program(CLI::App& app) {
  app.description("Waves in elastic solids by the spacetime discontinuous Galerkin method.\n");
  app.set_version_flag("--version", version_text(), "print the version and how it was built");
  app.set_help_flag("--help", "print this text");  // subcommands inherit it
  app.failure_message(failure_text);
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.get_formatter()->label("REQUIRED", "(required)");
}

/// Comes after the commands are added: they would inherit it.
void add_first_steps(CLI::App& app) {
  app.footer(
      "`tentpole COMMAND --help` lists the options of a command. A first run:\n"
      "  tentpole check examples/thesis_bar.toml     what would run\n"
      "  tentpole run examples/thesis_bar.toml       solve; the result goes to result_thesis_bar\n"
      "  tentpole plot result_thesis_bar             draw pictures of it\n\n"
      "Exit codes: 0 done, 1 the run failed, 2 bad input, 130 interrupted with a checkpoint.\n");
}

/// No command at all, or one that does not exist.
int refuse_missing_command(const CLI::App& app) {
  if (app.remaining_size() == 0) {
    std::cerr << app.help();
    return bad_input;
  }
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* each) { return !each->get_group().empty(); }))
    names.push_back(command->get_name());
  const std::string name = app.remaining().front();
  throw InputError("tentpole: there is no command " + name + ". " + suggestion(name, names));
}

int dispatch(int argc, char** argv) {
  CLI::App app("", "tentpole");
  describe_program(app);
  Arguments arguments;
  add_run(app, arguments.run);
  add_check(app, arguments.check);
  add_compare(app, arguments.compare);
  add_devices(app, arguments);
  app.add_subcommand("info", "describe a result folder, or a .json, .csv, .vtkhdf or .h5 file of one")
      ->add_option("FILE", arguments.described, "file or folder")
      ->required()
      ->type_name("");
  const CLI::App* plot = add_passing_command(app, "plot", "draw pictures from a result folder");
  add_model(app, arguments.model);
  add_first_steps(app);
  app.allow_extras();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : bad_input;
  }
  if (app.got_subcommand("run")) return run_command(arguments.run);
  if (app.got_subcommand("check")) return check_command(arguments.check);
  if (app.got_subcommand("compare")) return compare_command(arguments.compare);
  if (app.got_subcommand("devices")) return devices_command(arguments.calibrate);
  if (app.got_subcommand("info")) return info_command(arguments.described);
  if (app.got_subcommand(plot)) return plot_command(plot->remaining());
  if (app.got_subcommand("model")) return model_command(arguments.model);
  return refuse_missing_command(app);
}

}  // namespace

int run_command_line(int argc, char** argv) {
  prepare_hdf5();
  try {
    return dispatch(argc, argv);
  } catch (const InputError& error) {
    std::cerr << printable_lines(error.what()) << "\n";
    return bad_input;
  } catch (const MeshError& error) {
    std::cerr << printable_lines(error.what()) << "\n";
    return bad_input;
  } catch (const std::bad_alloc& error) {
    std::cerr << out_of_memory_text(error) << "\n";
    return failed;
  } catch (const std::exception& error) {
    std::cerr << "the run failed: " << printable_lines(error.what()) << "\n";
    return failed;
  }
}

}  // namespace tentpole
