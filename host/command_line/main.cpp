#include "host/command_line/command_line.hpp"
#include "host/command_line/wait_policy.hpp"

int main(int argc, char** argv) {
  tentpole::sleep_idle_threads(argv);
  return tentpole::run_command_line(argc, argv);
}
