#pragma once

namespace tentpole {

/// Catches, as long as it exists, the signals by which a person (SIGINT, Ctrl-C), a batch system (SIGTERM, SIGUSR1,
/// SIGUSR2), a closing terminal (SIGHUP) or a limit of processor time (SIGXCPU) wants a program to end. The first one
/// is noted, so that a run can finish its batch and write a checkpoint, and a line on stderr says so; after it a SIGINT
/// ends the program at once, and the others, which often come in pairs, change nothing. A SIGHUP that was ignored
/// before (nohup) stays so. One object at a time.
class Interrupt {
 public:
  /// `message` is what the first signal prints; it must outlive the object.
  explicit Interrupt(const char* message);
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Whether a signal has come.
  bool requested() const;
};

/// From now on a write to a closed pipe (SIGPIPE), or beyond the limit of file sizes (SIGXFSZ), is an error of that
/// write, which names the file, and not the end of the program.
void outlive_failed_writes();

}  // namespace tentpole
