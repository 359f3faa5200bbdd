#pragma once

#include "grid/scan_beams.hpp"
#include "grid/tile_loader.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rmap {

/// Beams of a scan that start at one place.
struct BeamGroup {
  Vector3d origin;  ///< metres
  /// Their numbers in the scan; empty when the group is the whole scan.
  std::vector<std::uint32_t> numbers;
  std::size_t size;
};

/// All beams of a scan by where they start, groups and beams in the order of the scan.
std::vector<BeamGroup> groups_by_origin(const ScanBeams& beams);
/// The same for some of the beams, given by their ascending numbers.
std::vector<BeamGroup> groups_by_origin(const ScanBeams& beams,
                                        std::span<const std::uint32_t> numbers);

/// use(tile, place) for the beams of a group from place `begin` to `end`, a tile at a time.
template <class Use>
void for_each_tile(const BeamGroup& group, std::size_t begin, std::size_t end, TileLoader& loader,
                   Use&& use) {
  PointTile tile;
  for (std::size_t place = begin; place < end; place += PointTile::kSize) {
    const std::size_t count = std::min(PointTile::kSize, end - place);
    if (group.numbers.empty()) {
      loader.load(place, count, tile);
    } else {
      loader.load(std::span(group.numbers).subspan(place, count), tile);
    }
    use(tile, place);
  }
}

}  // namespace rmap
