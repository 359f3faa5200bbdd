// Writes the seeds of all fuzz targets to a folder, one subfolder each: small sound files of every
// form that a reader knows, made by the library's writers where it has one.
#include "io/cuboid_samples.hpp"
#include "io/files.hpp"
#include "io/map_samples.hpp"
#include "io/raw_map.hpp"
#include "seeds.hpp"
#include "support/random.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include <rmap/cuboid_files.hpp>
#include <rmap/map_file.hpp>
#include <rmap/octomap_file.hpp>
#include <rmap/scan_files.hpp>

namespace rmap::test {
namespace {

std::string saved(const Grid& grid) {
  const TemporaryFolder folder;
  save(grid, folder / "a.rmap");
  return read_text(folder / "a.rmap");
}

// Blocks that are full, half full and far apart; some cells with the values at the limits.
Grid dense_map() {
  Grid grid({.resolution = 0.1});
  for (BlockPosition i = 0; i < kBlockCells; ++i) grid.set_value(block_offset(i), 850);
  for (int i = 0; i < 100; ++i) grid.set_value({i, -i, 40}, static_cast<Value>(7 * i - 300));
  grid.set_value(Cell::Constant(kMinCellIndex), -32768);
  grid.set_value(Cell::Constant(kMaxCellIndex), 32767);
  return grid;
}

void add_maps(Seeds& seeds) {
  const Grid empty({.resolution = 0.05});
  RawMap optional = raw_map(small_map());
  RawChunk unknown = raw_chunk("OBSV", "what later releases keep");
  unknown.flags = 0;
  optional.chunks.insert(optional.chunks.begin() + 2, unknown);
  optional.chunk("END ").stored = raw(std::uint64_t{optional.chunks.size() - 1});
  for (const std::string target : {"rmap_map", "rmap_info", "repair"}) {
    seeds.add(target, "empty", saved(empty));
    seeds.add(target, "small", saved(small_map()));
    seeds.add(target, "small_plain", bytes_of(raw_map(small_map())));
    seeds.add(target, "dense", saved(dense_map()));
    seeds.add(target, "dense_plain", bytes_of(raw_map(dense_map())));
    seeds.add(target, "optional_chunk", bytes_of(optional));
  }
}

void add_cuboids(Seeds& seeds) {
  Random random(14);
  const CuboidList compressed = near_cuboids(random, 60, 20);
  const CuboidList limits = random_cuboids(random, 12);
  for (const std::string ending : {"csv", "rcs"}) {
    seeds.add("cuboid_" + ending, "empty", written("." + ending, {.resolution = 0.1}));
    seeds.add("cuboid_" + ending, "small", written("." + ending, small_list()));
    seeds.add("cuboid_" + ending, "limits", written("." + ending, limits));
  }
  seeds.add("cuboid_rcs", "compressed", written(".rcs", compressed));
}

std::string points_as(const std::string& ending) {
  const TemporaryFolder folder;
  write_points(folder / ("a" + ending), nasty_points());
  return read_text(folder / ("a" + ending));
}

void add_scans(Seeds& seeds) {
  seeds.add("bin", "points", points_as(".bin"));
  seeds.add("bin", "point", std::string(16, '\x3f'));
  seeds.add("pcd", "binary", points_as(".pcd"));
  seeds.add("pcd", "ascii",
            "# .PCD v.7\nVERSION .7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\n"
            "COUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n"
            "1 2.5 -3e-2 4294967295\nnan inf 0 0\n");
  seeds.add("pcd", "types",
            "FIELDS time x normal z y\nSIZE 8 1 4 2 8\nTYPE U I F U I\nCOUNT 1 1 3 1 1\n"
            "WIDTH 1\nHEIGHT 2\nDATA binary\n" +
                std::string(62, '\x3f'));
  const std::string lzf = std::string("\0\x3f", 2) + "\xe0\x26" + std::string(1, '\0');
  seeds.add("pcd", "compressed",
            "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 2\nPOINTS 4\n"
            "DATA binary_compressed\n" +
                raw(static_cast<std::uint32_t>(lzf.size())) + raw(std::uint32_t{48}) + lzf);
  seeds.add("lzf", "reference", raw(std::uint16_t{48}) + lzf);
  seeds.add("lzf", "literals", raw(std::uint16_t{5}) + "\4abcde");
}

void add_poses(Seeds& seeds) {
  Random random(14);
  const TemporaryFolder folder;
  write_poses(folder / "poses.txt", random_poses(random, 4));
  seeds.add("poses", "matrices", read_text(folder / "poses.txt"));
  seeds.add("poses", "whole_matrix", "# one\n1 0 0 0.5 0 1 0 -2 0 0 1 3e2 0 0 0 1\n");
  seeds.add("poses", "quaternions", "1 2 3 0 0 0 1\n\n-1 +2 3.25 0.5 0.5 -0.5 0.5 # half\r\n");
  seeds.add("poses", "times", "1.5 1 2 3 0 0 0 2\n1e1 1 2 3 0 0 0.6 0.8\n");
}

// Inner nodes that lead to one leaf of the lowest level, as in tests/io/octomap_file_test.cpp.
std::string octomap(std::uint64_t nodes, const std::vector<std::uint16_t>& states) {
  std::string bytes = "# Octomap OcTree binary file\n# (a comment)\n#\nid OcTree\nsize " +
                      std::to_string(nodes) + "\nres 0.25\ndata\n";
  for (const std::uint16_t state : states) bytes += raw(state);
  return bytes;
}

void add_octomaps(Seeds& seeds) {
  std::vector<std::uint16_t> path(15, 3);  // the first child is an inner node
  seeds.add("octomap", "empty", octomap(0, {}));
  seeds.add("octomap", "free", octomap(2, {1}));
  path.push_back(0x2042);  // a free leaf and two occupied ones
  seeds.add("octomap", "leaves", octomap(19, path));
  path.resize(11);
  path.push_back(0x8001);  // an occupied leaf of 16^3 cells
  seeds.add("octomap", "large_leaf", octomap(14, path));
  Grid grid({.resolution = 0.1});
  for (int i = 0; i < 9; ++i) grid.set_value({i, -i, 2}, static_cast<Value>(300 * i - 1000));
  const TemporaryFolder folder;
  for (const std::string ending : {".ot", ".bt"}) {
    export_octomap(grid, folder / ("a" + ending));
    seeds.add("octomap_values", "cells" + ending, read_text(folder / ("a" + ending)));
  }
}

void add_texts(Seeds& seeds) {
  seeds.add("text", "numbers",
            "1 -2.5e-3 +7 nan -inf\r\n0x1p3 1e400 1e-400\t1e39\n18446744073709551615\n");
  seeds.add("natural_order", "digits", "scan2.bin\nscan10.bin\nscan010.bin");
  seeds.add("natural_order", "mixed", "1a2\n1a\n01a002b");
  seeds.add("arguments", "box", "0,-1,2.5,1e3,inf,+6");
  seeds.add("arguments", "vector", "1 2\t3");
  seeds.add("arguments", "frame", "0,0,0.6,0.8");
  seeds.add("arguments", "integer", "18446744073709551615");
  seeds.add("arguments", "word", "blocks");
  seeds.add("number_lines", "vectors", "# x y z\n1,2,3\n 4 5 6 # here\r\n\n-1e-3\t+2 inf\n");
  seeds.add("number_lines", "boxes", "0,0,0,1,1,1\n0 0 0 , 1 1 1");
  seeds.add("number_lines", "zero_byte", "1,2,3" + std::string(1, '\0') + "4\n5,6,7\n");
}

}  // namespace
}  // namespace rmap::test

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: rmap_fuzz_seeds FOLDER\n");
    return 2;
  }
  try {
    rmap::test::Seeds seeds(argv[1]);
    rmap::test::add_maps(seeds);
    rmap::test::add_cuboids(seeds);
    rmap::test::add_scans(seeds);
    rmap::test::add_poses(seeds);
    rmap::test::add_octomaps(seeds);
    rmap::test::add_texts(seeds);
    rmap::test::add_clouds(seeds);
    rmap::test::add_bags(seeds);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rmap_fuzz_seeds: %s\n", error.what());
    return 1;
  }
}
