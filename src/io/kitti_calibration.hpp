#pragma once

#include <filesystem>
#include <optional>

#include <rmap/pose.hpp>

namespace rmap {

/// The line `Tr:` (or `Tr_velo_to_cam:`) of KITTI's calib.txt: 12 numbers, a 3x4 matrix by
/// rows, that carry points of the lidar into the camera's frame. Nothing when the file has no
/// such line. Throws Error(input) when it is no pose.
std::optional<Pose> read_kitti_calibration(const std::filesystem::path& file);

}  // namespace rmap
