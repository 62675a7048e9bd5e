#pragma once

namespace tentpole {

/// Catches SIGINT (Ctrl-C) and SIGTERM as long as it exists. The first one is noted, so that a run can finish its batch
/// and write a checkpoint, and a line on stderr says so; a second one ends the program at once, as without this class.
/// One object at a time.
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

}  // namespace tentpole
