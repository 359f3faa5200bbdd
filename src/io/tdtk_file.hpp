#pragma once

#include "io/input_file.hpp"
#include "io/point_cloud.hpp"

namespace rmap {

/// Reads a scan of 3DTK, `scanNNN.3d`: a line of text for each point, x y z in centimetres
/// along left-handed axes (x right, y up, z ahead) and numbers behind them that are passed
/// over. They become metres along x ahead, y left, z up.
void read_3dtk(InputFile& file, const PointReadOptions& options, PointCloud& cloud);

/// Reads the pose of such a scan, `scanNNN.pose`: three numbers of its position, centimetres,
/// and three angles about x, y and z, degrees; six in all. Throws Error(input).
Pose read_3dtk_pose(const std::filesystem::path& file);

}  // namespace rmap
