#pragma once

#include "io/input_file.hpp"
#include "io/point_cloud.hpp"

namespace rmap {

/// Reads a `.bin` file of other columns than KITTI's: those of `options.columns`, which are
/// not empty. Throws Error(usage) when they have no x, y and z or an unknown type.
void read_bin_columns(InputFile& file, const PointReadOptions& options, PointCloud& cloud);

}  // namespace rmap
