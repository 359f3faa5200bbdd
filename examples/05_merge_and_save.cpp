// Two robots, two maps, one file.
#include <filesystem>
#include <iostream>

#include <rmap/rmap.hpp>

int main() {
  const rmap::Simulation room = rmap::make_simulation("room");
  rmap::Grid first({.resolution = 0.1});
  rmap::Grid second({.resolution = 0.1});
  for (std::size_t i = 0; i < room.size(); ++i) {
    (i < room.size() / 2 ? first : second).insert(room.scan(i));
  }

  // Where both know a cell, their evidence adds up; a cell that one map has keeps its value.
  const rmap::MapDifference difference = rmap::compare(first, second);
  std::cout << difference.both << " cells are in both maps, " << difference.only_a
            << " in the first only, " << difference.only_b << " in the second only\n";
  first.merge(second);
  std::cout << "merged: " << first.cell_count() << " cells\n";

  // A file is complete or not there at all, and holds the map bit for bit.
  const std::filesystem::path file = "merged.rmap";
  rmap::save(first, file);
  const rmap::Grid loaded = rmap::load(file);
  std::cout << "saved in " << rmap::read_map_info(file).file_size << " bytes; loaded: "
            << (rmap::same_map(first, loaded) ? "the same map\n" : "another map\n");

  // The layout in memory is a choice, not a part of the map.
  const rmap::Grid cells = rmap::load(file, {.layout = rmap::Layout::cells});
  std::cout << loaded.bytes_in_use().total() / 1024 << " KiB in blocks, "
            << cells.bytes_in_use().total() / 1024 << " KiB with a leaf for each cell: "
            << (rmap::same_map(loaded, cells) ? "the same map\n" : "another map\n");

  // Every failure is one exception with one sentence.
  try {
    first.merge(rmap::Grid({.resolution = 0.2}));
  } catch (const rmap::Error& error) {
    std::cout << "refused: " << error.what() << "\n";
  }
}
