#include "cuboid_report.hpp"
#include "info.hpp"
#include "words.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <rmap/cuboid_files.hpp>

namespace rmap::command {

Description describe_cuboids(const std::filesystem::path& file) {
  const CuboidList list = read_cuboids(file);
  const Lattice lattice(list.resolution);
  CellBox bounds;
  double volume = 0;
  std::uint64_t points = 0;
  for (const Cuboid& cuboid : list.cuboids) {
    bounds = volume == 0 ? cuboid.cells : united(bounds, cuboid.cells);
    volume += cuboid.cells.volume();
    points += cuboid.points;
  }
  const Box box = lattice.metric(bounds);
  const bool none = list.cuboids.empty();
  Json json{
      {"file", file.string()},
      {"kind", "cuboids"},
      {"resolution", list.resolution},
      {"cuboids", list.cuboids.size()},
      {"points", points},
      {"cells", json_of_count(volume)},
      {"bounds", none ? Json(nullptr) : json_of(box)},
      {"frame", json_of_frame(list.frame)},
      {"bytes", {{"file", std::filesystem::file_size(file)}, {"plain", 24 * list.cuboids.size()}}}};
  std::string words = fmt::format(
      "{}: {} of cells of {} m\n"
      "volume       {} cells, counted once for each cuboid\n"
      "bounds       {}\n"
      "frame        {}\n"
      "bytes        {} in the file, {} plain\n",
      file.string(), counted(list.cuboids.size(), "cuboid"), list.resolution,
      grouped(static_cast<std::uint64_t>(volume)), none ? "none" : readable_box(box) + " m",
      readable_frame(list.frame), grouped(std::filesystem::file_size(file)),
      grouped(24 * list.cuboids.size()));
  return {std::move(json), std::move(words)};
}

}  // namespace rmap::command
