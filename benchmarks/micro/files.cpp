// Files: a map saved and loaded, by its bytes in use; a scan read, by its bytes.
#include "micro/street.hpp"

#include <filesystem>
#include <string>
#include <unistd.h>

#include <rmap/map_file.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap::bench {
namespace {

// A path that is removed in the end, with all that is there.
class ScratchPath {
 public:
  explicit ScratchPath(const std::string& name)
      : path_(std::filesystem::temp_directory_path() /
              ("rmap_bench_" + std::to_string(::getpid()) + "_" + name)) {}
  ScratchPath(const ScratchPath&) = delete;
  ScratchPath& operator=(const ScratchPath&) = delete;
  ~ScratchPath() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& get() const { return path_; }

 private:
  std::filesystem::path path_;
};

void set_bytes(benchmark::State& state, std::size_t bytes) {
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes) * state.iterations());
}

void save_map(benchmark::State& state) {
  const Grid grid = street_map();
  const ScratchPath file("save.rmap");
  for (auto _ : state) save(grid, file.get());
  set_bytes(state, grid.bytes_in_use().total());
}
BENCHMARK(save_map)->Unit(benchmark::kMillisecond);

void load_map(benchmark::State& state) {
  const Grid grid = street_map();
  const ScratchPath file("load.rmap");
  save(grid, file.get());
  if (!right(state, same_map(load(file.get()), grid))) return;
  for (auto _ : state) benchmark::DoNotOptimize(load(file.get()).cell_count());
  set_bytes(state, grid.bytes_in_use().total());
}
BENCHMARK(load_map)->Unit(benchmark::kMillisecond);

void read_scan(benchmark::State& state, const char* ending) {
  const ScratchPath folder("scans");
  ScanFolderWriter writer(folder.get(), ending);
  writer.add(street_scans().front());
  writer.finish();
  const std::size_t points = street_scans().front().points.size();
  for (auto _ : state) {
    for (const Scan& scan : read_scans(folder.get())) {
      if (!right(state, scan.points.size() == points)) return;
    }
  }
  set_units(state, points);
}
BENCHMARK_CAPTURE(read_scan, bin, ".bin")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_scan, pcd, ".pcd")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rmap::bench
