#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

namespace rmap::command {

/// A line on standard error that says how far a job over scans is, at which rate, and
/// how long it will take yet. Only on a terminal; wiped away at the end.
class Progress {
 public:
  /// `doing`: what is being done, as "inserting"; `total`: number of scans, where known.
  Progress(std::string doing, std::optional<std::size_t> total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// One scan more is done.
  void advance();

 private:
  using Clock = std::chrono::steady_clock;

  void show(Clock::time_point now);

  bool visible_;
  std::string doing_;
  std::optional<std::size_t> total_;
  std::size_t done_ = 0;
  Clock::time_point start_;
  Clock::time_point next_;
};

}  // namespace rmap::command
