#include "io/cuboid_formats.hpp"
#include "io/memory.hpp"
#include "io/text.hpp"

#include <array>
#include <string>

#include <fmt/format.h>

#include <rmap/cuboid_files.hpp>
#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

struct CuboidFormat {
  std::string_view ending;
  void (*write)(AtomicFile& file, const CuboidList& list);
  CuboidList (*read)(const std::filesystem::path& file);  ///< null where files are only written
};

constexpr std::array kFormats = {
    CuboidFormat{".rcs", write_cuboid_rcs, read_cuboid_rcs},
    CuboidFormat{".csv", write_cuboid_csv, read_cuboid_csv},
    CuboidFormat{".json", write_cuboid_json, nullptr},
    CuboidFormat{".ply", write_cuboid_ply, nullptr},
    CuboidFormat{".glb", write_cuboid_glb, nullptr},
    CuboidFormat{".urdf", write_cuboid_urdf, nullptr},
    CuboidFormat{".sdf", write_cuboid_sdf, nullptr},
    CuboidFormat{".xml", write_cuboid_mjcf, nullptr},
    CuboidFormat{".scene", write_cuboid_scene, nullptr},
};

const CuboidFormat* find_format(std::string_view ending) {
  for (const CuboidFormat& format : kFormats) {
    if (format.ending == ending) return &format;
  }
  return nullptr;
}

Error ending_error(const std::filesystem::path& file, std::string_view allowed) {
  return {ErrorKind::input, fmt::format("the ending of {} is {}, where {} are allowed",
                                        file.string(), in_quotes(ending_of(file)), allowed)};
}

}  // namespace

void check_cuboids(const CuboidList& list) {
  Lattice{list.resolution};
  check_pose(list.frame);
  const CellBox all = all_cells();
  for (std::size_t i = 0; i < list.cuboids.size(); ++i) {
    const CellBox& cells = list.cuboids[i].cells;
    if (all.contains(cells)) continue;
    throw Error(
        ErrorKind::input,
        fmt::format("cuboid {} from ({}, {}, {}) to ({}, {}, {}) {}", i, cells.min.x(),
                    cells.min.y(), cells.min.z(), cells.max.x(), cells.max.y(), cells.max.z(),
                    cells.empty() ? "is empty: max must be greater than min on each axis"
                                  : "is beyond the limits of cell indices"));
  }
}

void write_cuboids(const std::filesystem::path& file, const CuboidList& list) {
  const CuboidFormat* format = find_format(ending_of(file));
  if (format == nullptr) {
    throw ending_error(file, ".rcs, .csv, .json, .ply, .glb, .urdf, .sdf, .xml and .scene");
  }
  check_cuboids(list);
  AtomicFile output(file);
  format->write(output, list);
  output.commit();
}

CuboidList read_cuboids(const std::filesystem::path& file) {
  const CuboidFormat* format = find_format(ending_of(file));
  if (format == nullptr || format->read == nullptr) throw ending_error(file, ".rcs and .csv");
  return with_memory_for(file, [&] { return format->read(file); });
}

}  // namespace rmap
