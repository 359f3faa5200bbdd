// Memory of whole maps: what rmap and liboctomap hold for the same sequence,
// every allocation counted in one process, and in how much of the cells they agree.
//
//   rmap_bench_memory [FOLDER] [--resolution METRES] [--no-octomap]
//
// FOLDER holds sequences (folders of scans); without it the real data of the
// tests (RMAP_DATA) and one simulated street are used. Prints a Markdown table.
#include "counted_heap.hpp"
#include "support/octomap_twin.hpp"
#include "support/real_data.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <octomap/octomap.h>

#include <rmap/cells.hpp>
#include <rmap/scan_source.hpp>
#include <rmap/simulation.hpp>

namespace {

struct Sequence {
  std::string name;
  std::vector<rmap::Scan> scans;
};

std::vector<Sequence> read_sequences(const std::filesystem::path& folder) {
  std::vector<Sequence> sequences;
  if (std::filesystem::is_directory(folder)) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.is_directory()) paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    for (const auto& path : paths) {
      sequences.push_back({path.filename().string(), {}});
      for (const rmap::Scan& scan : rmap::read_scans(path)) {
        sequences.back().scans.push_back(rmap::test::in_map_frame(scan));
      }
    }
  }
  sequences.push_back({"street (simulated)", {}});
  for (const rmap::Scan& scan : rmap::make_simulation("street")) {
    sequences.back().scans.push_back(rmap::test::in_map_frame(scan));
  }
  return sequences;
}

struct RmapFigures {
  std::size_t cells = 0;
  std::size_t occupied = 0;
  std::size_t counted = 0;   // bytes, by the replaced operator new
  std::size_t reported = 0;  // bytes, by Grid::bytes_in_use
};

RmapFigures measure_rmap(const std::vector<rmap::Scan>& scans, double resolution, bool complete) {
  const std::size_t before = rmap::bench::heap_use().taken;
  rmap::Grid grid({.resolution = resolution});
  if (complete) {
    for (const rmap::Scan& scan : scans) grid.prepare(scan);
  }
  for (const rmap::Scan& scan : scans) grid.insert(scan);
  return {.cells = grid.cell_count(),
          .occupied = rmap::count_cells(grid, {.occupied_only = true}),
          .counted = rmap::bench::heap_use().taken - before,
          .reported = grid.bytes_in_use().total()};
}

struct OctomapFigures {
  std::size_t occupied = 0;
  std::size_t counted = 0;
  std::size_t formula = 0;  // inner * 80 + leaves * 16 bytes [RMAP 3.2]
};

OctomapFigures measure_octomap(const std::vector<rmap::Scan>& scans, double resolution) {
  const std::size_t before = rmap::bench::heap_use().taken;
  octomap::OcTree tree(resolution);
  for (const rmap::Scan& scan : scans) rmap::test::insert_into(tree, scan);
  OctomapFigures figures{.counted = rmap::bench::heap_use().taken - before};
  const std::size_t leaves = tree.getNumLeafNodes();
  figures.formula = (tree.size() - leaves) * 80 + leaves * 16;
  figures.occupied = rmap::test::occupied_cells(tree).size();
  return figures;
}

void print_row(const Sequence& sequence, double resolution, bool with_octomap) {
  const auto first = measure_rmap(sequence.scans, resolution, false);
  const auto complete = measure_rmap(sequence.scans, resolution, true);
  const auto per_cell = [](const RmapFigures& figures) {
    return static_cast<double>(figures.counted) / static_cast<double>(figures.cells);
  };
  fmt::print("| {} | {} | {} | {:.2f} | {:.2f} | {:.3f} | {} | {} |", sequence.name, complete.cells,
             complete.counted, per_cell(complete), per_cell(first),
             static_cast<double>(complete.reported) / static_cast<double>(complete.counted),
             complete.occupied, first.occupied);
  if (with_octomap) {
    const auto octomap = measure_octomap(sequence.scans, resolution);
    fmt::print(" {} | {} | {} | {:.0f} |", octomap.occupied, octomap.counted, octomap.formula,
               static_cast<double>(octomap.counted) / static_cast<double>(complete.counted));
  }
  fmt::print("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const auto data = rmap::test::data_folder();
  std::filesystem::path folder = data.empty() ? data : data / "sequences";
  double resolution = 0.1;
  bool with_octomap = true;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--resolution") == 0 && i + 1 < argc) {
      resolution = std::stod(argv[++i]);
    } else if (std::strcmp(argv[i], "--no-octomap") == 0) {
      with_octomap = false;
    } else {
      folder = argv[i];
    }
  }
  fmt::print("Resolution {} m; bytes counted at operator new; cells of complete history.\n\n",
             resolution);
  fmt::print(
      "| sequence | cells | bytes | bytes/cell | bytes/cell first-hit | reported/counted | "
      "occupied "
      "| occupied first-hit |{}\n",
      with_octomap ? " occupied OctoMap | bytes OctoMap | by the paper's formula | times less |"
                   : "");
  fmt::print("|---|---|---|---|---|---|---|---|{}\n", with_octomap ? "---|---|---|---|" : "");
  for (const Sequence& sequence : read_sequences(folder)) {
    print_row(sequence, resolution, with_octomap);
  }
}
