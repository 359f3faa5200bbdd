// Prints how the public types lie in memory and what a map holds to the last bit. Neither may
// depend on the flags that a program is compiled with, since the library has been compiled already.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include <rmap/rmap.hpp>

namespace {

// Size and alignment of a type, and where in `object` the fields lie.
template <class Type, class... Fields>
void print_layout(const char* name, const Type& object, const Fields&... fields) {
  const auto* start = reinterpret_cast<const std::byte*>(&object);
  std::printf("%s: %zu bytes, aligned to %zu", name, sizeof(Type), alignof(Type));
  if (sizeof...(fields) > 0) std::printf(", fields at");
  (std::printf(" %td", reinterpret_cast<const std::byte*>(&fields) - start), ...);
  std::printf("\n");
}

void print_layouts() {
  print_layout("Pose", rmap::Pose::Identity());
  const rmap::Box box;
  print_layout("Box", box, box.min, box.max);
  const rmap::CellBox cells;
  print_layout("CellBox", cells, cells.min, cells.max);
  const rmap::Scan scan;
  print_layout("Scan", scan, scan.map_from_sensor, scan.frame, scan.points, scan.origins,
               scan.no_returns, scan.sensor_range, scan.name);
  const rmap::Options options;
  print_layout("Options", options, options.resolution, options.layout, options.max_branches,
               options.split, options.prob_hit, options.free_probability, options.saturation,
               options.min_range, options.max_range, options.beams, options.bad_points,
               options.threads);
  const rmap::InsertReport report;
  print_layout("InsertReport", report, report.points, report.skipped, report.misses);
  const rmap::BytesInUse bytes;
  print_layout("BytesInUse", bytes, bytes.nodes, bytes.blocks, bytes.values, bytes.records);
  const rmap::RayHit hit{};
  print_layout("RayHit", hit, hit.cell, hit.point, hit.face, hit.distance);
  const rmap::BoxOccupancy occupancy;
  print_layout("BoxOccupancy", occupancy, occupancy.box, occupancy.mean, occupancy.occupied);
  const rmap::QueryCuboid cuboid{};
  print_layout("QueryCuboid", cuboid, cuboid.box, cuboid.mean, cuboid.max, cuboid.existing);
  const rmap::CellSelection selection;
  print_layout("CellSelection", selection, selection.box, selection.sphere,
               selection.occupied_only);
  const rmap::CellRow row;
  print_layout("CellRow", row, row.center, row.size, row.probability, row.occupied);
  const rmap::Changes changes;
  print_layout("Changes", changes, changes.revision, changes.blocks, changes.cells,
               changes.complete);
  const rmap::Leaf leaf{};
  print_layout("Leaf", leaf, leaf.origin, leaf.edge, leaf.content);
  const rmap::SceneObject object;
  print_layout("SceneObject", object, object.shape, object.map_from_object, object.motion,
               object.visible_until);
  print_layout("Beam", rmap::Beam({0, 0, 0}, {1, 1, 1}, false));
  print_layout("Lattice", rmap::Lattice(0.1));
  print_layout("RTree", rmap::RTree<std::uint32_t>());
}

// FNV-1a over 64-bit words.
class Digest {
 public:
  void add(std::uint64_t word) { state_ = (state_ ^ word) * 0x100000001B3u; }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xCBF29CE484222325u;
};

void print_map() {
  rmap::Grid grid({.resolution = 0.07, .max_range = 9});
  // Poses that share no axis with the map, so that every rounding counts.
  const rmap::Simulation room = rmap::make_simulation("tilted_room", {.scans = 3, .noise = 0.01});
  for (const rmap::Scan& scan : room) grid.insert(scan);

  Digest cells;
  for (const auto& [cell, value] : rmap::cells(grid)) {
    for (const std::int32_t index : cell) cells.add(static_cast<std::uint64_t>(index));
    cells.add(static_cast<std::uint64_t>(value));
    for (const double metres : grid.lattice().center(cell)) cells.add(metres);
  }
  std::printf("%zu cells: %016llx\n", grid.cell_count(),
              static_cast<unsigned long long>(cells.value()));

  Digest answers;
  for (const rmap::Vector3d& direction : rmap::beam_directions(room.sensor().model, 0)) {
    const auto hit = rmap::cast_ray(grid, room.map_from_sensor(1).translation(), direction, 20);
    answers.add(hit ? hit->distance : -1.0);
  }
  answers.add(rmap::probability(grid, {.min = {-3, -2, 0}, .max = {2, 2.2, 2}}));
  std::printf("answers: %016llx\n", static_cast<unsigned long long>(answers.value()));
}

}  // namespace

int main() {
  print_layouts();
  print_map();
}
