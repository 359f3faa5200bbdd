#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace rmap::evaluation {

/// Milliseconds of processor time that `work` takes, of all threads: unlike the clock on the wall
/// it does not count what others do on the machine meanwhile.
template <class Work>
double milliseconds_of(Work&& work) {
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

/// The middle of some values, the upper one of an even number; 0 of none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace rmap::evaluation
