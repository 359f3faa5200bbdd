#pragma once

namespace rmap::command {

/// From here on a closed pipe and a file beyond the limit of sizes are errors of the
/// write instead of the end of the process, and SIGHUP, SIGINT or SIGTERM end the
/// command at once with the exit code 128 + signal, unless a SignalHold lives. Signals that the
/// caller has switched off stay off.
void install_signal_handlers();

/// Says whether the last line on the terminal lacks its end, as a line of progress does:
/// a signal that ends the command at once then ends the line too.
void set_line_open(bool open);

/// A signal has come while it was held: the command is to clean up and end with
/// `exit_code`. Not a failure, hence no Error.
struct Interrupted {
  int exit_code;
};

/// While one lives SIGHUP, SIGINT and SIGTERM wait, so that files are completed or removed
/// first. Any number may be nested.
class SignalHold {
 public:
  SignalHold();
  SignalHold(const SignalHold&) = delete;
  SignalHold& operator=(const SignalHold&) = delete;
  ~SignalHold();

  /// Throws Interrupted when a signal has come.
  void check() const;
};

}  // namespace rmap::command
