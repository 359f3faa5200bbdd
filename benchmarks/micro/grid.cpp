// Making a map: beams inserted and prepared, by traversal, layout and threads; copies; merging.
#include "micro/street.hpp"

#include <string>

namespace rmap::bench {
namespace {

struct Setup {
  const char* name;
  Options options;
};

const std::vector<Setup>& setups() {
  static const std::vector<Setup> kSetups = {
      {"inverse", {.resolution = 0.1, .traversal = Traversal::inverse}},
      {"forward", {.resolution = 0.1, .traversal = Traversal::forward}},
      {"inverse 0.05", {.resolution = 0.05, .traversal = Traversal::inverse}},
      {"inverse 0.2", {.resolution = 0.2, .traversal = Traversal::inverse}},
      {"cells", {.resolution = 0.1, .layout = Layout::cells, .traversal = Traversal::inverse}},
      {"per_end_cell",
       {.resolution = 0.1, .beams = Beams::per_end_cell, .traversal = Traversal::inverse}},
      {"2 threads", {.resolution = 0.1, .traversal = Traversal::inverse, .threads = 2}},
  };
  return kSetups;
}

Grid inserted(const Options& options) {
  Grid grid(options);
  for (const Scan& scan : street_scans()) grid.insert(scan);
  return grid;
}

// The same map by the plain way: one thread, in blocks, each beam followed.
Options plain(Options options) {
  options.layout = Layout::blocks;
  options.traversal = Traversal::forward;
  options.threads = 1;
  return options;
}

void insert(benchmark::State& state, const Options& options) {
  if (!right(state, same_map(inserted(options), inserted(plain(options))))) return;
  for (auto _ : state) benchmark::DoNotOptimize(inserted(options).cell_count());
  set_units(state, street_beams());
}

void prepare(benchmark::State& state, const Options& options) {
  for (auto _ : state) {
    Grid grid(options);
    for (const Scan& scan : street_scans()) grid.prepare(scan);
    benchmark::DoNotOptimize(grid.cell_count());
  }
  set_units(state, street_beams());
}

void copy(benchmark::State& state) {
  const Grid grid = street_map();
  if (!right(state, same_map(Grid(grid), grid))) return;
  for (auto _ : state) benchmark::DoNotOptimize(Grid(grid).cell_count());
  set_units(state, grid.cell_count());
}
BENCHMARK(copy)->Unit(benchmark::kMillisecond);

void merge(benchmark::State& state) {
  const Grid grid = street_map();
  for (auto _ : state) {
    Grid sum({.resolution = 0.1});
    sum.merge(grid);
    sum.merge(grid);
    if (!right(state, sum.cell_count() == grid.cell_count())) return;
  }
  set_units(state, 2 * grid.cell_count());
}
BENCHMARK(merge)->Unit(benchmark::kMillisecond);

void add(const std::string& name, void (*work)(benchmark::State&, const Options&),
         const Options& options) {
  benchmark::RegisterBenchmark(name.c_str(), work, options)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

const bool kRegistered = [] {
  for (const Setup& setup : setups()) {
    add("insert/" + std::string(setup.name), insert, setup.options);
    add("prepare/" + std::string(setup.name), prepare, setup.options);
  }
  return true;
}();

}  // namespace
}  // namespace rmap::bench
