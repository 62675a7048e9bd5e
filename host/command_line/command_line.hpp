#pragma once

namespace tentpole {

/// The program `tentpole`: reads the arguments, runs the command that they name and returns the exit code: 0 done, 1
/// the run failed, 2 bad input, 130 interrupted with a checkpoint. All errors end here, as text on stderr.
int run_command_line(int argc, char** argv);

}  // namespace tentpole
