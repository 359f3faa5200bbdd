#pragma once

#include <cstddef>
#include <vector>

#include <benchmark/benchmark.h>

#include <rmap/grid.hpp>
#include <rmap/scan.hpp>

namespace rmap::bench {

/// What the small benchmarks work on: scans of the simulated street, made once.
const std::vector<Scan>& street_scans();
std::size_t street_beams();
/// Its map at 0.1 m.
Grid street_map(const Options& options = {.resolution = 0.1});
/// The occupied cells of that map.
const std::vector<Cell>& street_surface();

/// Tells the clock that each iteration did so many units of work: items_per_second counts these.
inline void set_units(benchmark::State& state, std::size_t units) {
  state.SetItemsProcessed(static_cast<std::int64_t>(units) * state.iterations());
}
/// Stops a benchmark whose answer is wrong, before its time counts.
inline bool right(benchmark::State& state, bool answer) {
  if (!answer) state.SkipWithError("the answer is wrong");
  return answer;
}

}  // namespace rmap::bench
