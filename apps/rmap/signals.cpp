#include "signals.hpp"

#include <csignal>
#include <initializer_list>
#include <unistd.h>

namespace rmap::command {

namespace {

constexpr int kSignalExitBase = 128;  // as shells report a signal

// Signal handlers may touch nothing else.
volatile std::sig_atomic_t holds = 0;
volatile std::sig_atomic_t waiting_signal = 0;
volatile std::sig_atomic_t line_open = 0;

void end_line() {
  // A terminal that is gone needs no end of line.
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, "\n", 1);
}

void on_signal(int signal) {
  if (holds == 0) {
    if (line_open != 0) end_line();
    ::_exit(kSignalExitBase + signal);
  }
  waiting_signal = signal;
}

}  // namespace

void install_signal_handlers() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
    // Under nohup, say, the caller does not want the command to be interrupted.
    if (std::signal(signal, on_signal) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

void set_line_open(bool open) { line_open = open ? 1 : 0; }

SignalHold::SignalHold() { holds = holds + 1; }

SignalHold::~SignalHold() { holds = holds - 1; }

void SignalHold::check() const {
  if (waiting_signal != 0) throw Interrupted{kSignalExitBase + waiting_signal};
}

}  // namespace rmap::command
