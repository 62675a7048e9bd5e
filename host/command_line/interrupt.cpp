#include "host/command_line/interrupt.hpp"

#include <csignal>
#include <cstring>

#include <unistd.h>

namespace tentpole {
namespace {

// A signal handler can reach nothing but globals.
volatile std::sig_atomic_t signal_came = 0;
const char* first_message = "";

void stop_catching() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

/// Calls functions that are safe in a signal handler only (signal, strlen, write).
extern "C" void note_signal(int) {
  signal_came = 1;
  stop_catching();
  [[maybe_unused]] const auto written = write(STDERR_FILENO, first_message, std::strlen(first_message));
}

}  // namespace

Interrupt::Interrupt(const char* message) {
  signal_came = 0;
  first_message = message;
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
}

Interrupt::~Interrupt() {
  stop_catching();
}

bool Interrupt::requested() const {
  return signal_came != 0;
}

}  // namespace tentpole
