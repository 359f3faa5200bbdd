#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <rmap/counted_cells.hpp>
#include <rmap/cuboid_frame.hpp>
#include <rmap/octomap_file.hpp>

namespace rmap::command {

/// In which frame cuboids are wanted.
struct FrameChoice {
  bool estimate = false;
  Pose given = Pose::Identity();  ///< unless it is estimated
  CuboidPhase phase = CuboidPhase::zero;
};

/// What is to be approximated: the occupied cells of a map, or the cells of a cloud or of scans.
struct CuboidInput {
  std::vector<CountedCell> cells;
  double resolution = 0;
  Pose frame = Pose::Identity();  ///< from the input's frame to that of the cells
  std::string why_frame;
  std::uint64_t not_finite = 0;
  std::uint64_t beyond_limits = 0;
  double seconds_read = 0;
  double seconds_quantise = 0;
  double seconds_frame = 0;
};

struct CuboidInputOptions {
  /// Edge of a cell for points, metres; maps have their own, which this must not contradict.
  std::optional<double> resolution;
  FrameChoice frame = {};
  std::uint64_t max_cells = kOctomapMaxCells;  ///< of a map of OctoMap
  int outer = 1;                               ///< for the trial of an estimated frame
  int threads = 1;
};

/// Reads a map (.rmap, .bt, .ot), a cloud (.bin, .pcd), or a folder of scans with poses. Throws
/// Error as its reader does, Error(input) for a frame or a resolution that a map does not have.
CuboidInput read_cuboid_input(const std::filesystem::path& file, const CuboidInputOptions& options);

/// "identity", "estimate", or a quaternion qx,qy,qz,qw; throws UsageError.
FrameChoice frame_argument(const std::string& text);

}  // namespace rmap::command
