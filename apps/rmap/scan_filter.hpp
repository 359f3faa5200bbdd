#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <rmap/box.hpp>
#include <rmap/scan.hpp>

namespace rmap::command {

/// Points that are left out of a build on request, each with its beam.
struct ScanFilter {
  /// Sensor's frame: what lies in one is no part of the world, as the robot itself.
  std::vector<Box> ignore = {};
  /// Map's frame: what lies outside is not wanted. A beam that ends outside does not
  /// clear inside either.
  std::optional<Box> crop = {};

  struct Counts {
    std::uint64_t ignored = 0;
    std::uint64_t cropped = 0;
  };

  /// Takes such points out of `scan` and adds to `counts`; a point that both apply to is
  /// ignored. Points that are not finite stay: the map counts them.
  void apply(Scan& scan, Counts& counts) const;
};

}  // namespace rmap::command
