#include "host/command_line/interrupt.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>

#include <unistd.h>

namespace tentpole {
namespace {

// A signal handler can reach nothing but globals.
volatile std::sig_atomic_t signal_came = 0;
const char* first_message = "";

constexpr int caught_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU};

/// Calls functions that are safe in a signal handler only (signal, strlen, write).
extern "C" void note_signal(int) {
  std::signal(SIGINT, SIG_DFL);
  if (signal_came != 0) return;
  signal_came = 1;
  const int error = errno;  // of the code that was interrupted
  [[maybe_unused]] const auto written = write(STDERR_FILENO, first_message, std::strlen(first_message));
  errno = error;
}

}  // namespace

Interrupt::Interrupt(const char* message) {
  signal_came = 0;
  first_message = message;
  for (const int number : caught_signals) {
    const auto before = std::signal(number, note_signal);
    if (number == SIGHUP && before == SIG_IGN) std::signal(number, SIG_IGN);
  }
}

Interrupt::~Interrupt() {
  for (const int number : caught_signals)
    if (std::signal(number, SIG_DFL) == SIG_IGN) std::signal(number, SIG_IGN);
}

bool Interrupt::requested() const {
  return signal_came != 0;
}

void outlive_failed_writes() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace tentpole
