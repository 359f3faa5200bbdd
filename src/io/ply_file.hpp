#pragma once

#include "io/input_file.hpp"
#include "io/point_cloud.hpp"

namespace rmap {

/// Reads the vertices of a PLY file: ascii or binary of either byte order, x, y and z among
/// properties of any order and type. Other elements, faces say, are passed over, but must be
/// there as the header says: a file that is cut short is an error.
void read_ply(InputFile& file, const PointReadOptions& options, PointCloud& cloud);

}  // namespace rmap
