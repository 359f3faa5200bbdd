#include "progress.hpp"

#include "output.hpp"
#include "signals.hpp"

#include <cstdio>
#include <utility>

#include <fmt/format.h>

namespace rmap::command {

namespace {

constexpr std::chrono::milliseconds kInterval{100};
constexpr char kWipeLine[] = "\r\x1b[K";

}  // namespace

Progress::Progress(std::string doing, std::optional<std::size_t> total)
    : visible_(error_is_terminal()),
      doing_(std::move(doing)),
      total_(total),
      start_(Clock::now()),
      next_(start_) {}

Progress::~Progress() {
  if (!visible_) return;
  std::fputs(kWipeLine, stderr);
  set_line_open(false);
}

void Progress::advance() {
  ++done_;
  if (!visible_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + kInterval;
  show(now);
}

void Progress::show(Clock::time_point now) {
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = seconds > 0 ? static_cast<double>(done_) / seconds : 0;
  std::string line = fmt::format("{}{}: {}", kWipeLine, doing_, done_);
  if (total_) line += fmt::format(" of {}", *total_);
  line += fmt::format(" scans, {:.1f} scans/s", rate);
  if (total_ && rate > 0 && *total_ >= done_) {
    line += fmt::format(", {:.0f} s left", static_cast<double>(*total_ - done_) / rate);
  }
  std::fputs(line.c_str(), stderr);
  set_line_open(true);
}

}  // namespace rmap::command
