#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <rmap/box.hpp>
#include <rmap/scan.hpp>

namespace rmap {

/// Points that are left out of a map on request, each with its beam.
struct ScanFilter {
  /// Metres, sensor's frame: what lies in one is no part of the world, as the robot itself.
  std::vector<Box> ignore = {};
  /// Metres, map's frame: what lies outside is not wanted. A beam that ends outside does not
  /// clear inside either.
  std::optional<Box> crop = {};

  /// Points left out, by reason.
  struct Counts {
    std::uint64_t ignored = 0;
    std::uint64_t cropped = 0;
  };

  /// Takes such points out of `scan`, whichever frame they are in, and adds to `counts`; a
  /// point that both apply to is ignored. Points that are not finite stay: the map counts
  /// them. So do directions without return, which have no end.
  void apply(Scan& scan, Counts& counts) const;
};

}  // namespace rmap
