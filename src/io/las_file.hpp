#pragma once

#include "io/input_file.hpp"
#include "io/point_cloud.hpp"

#include <string_view>

namespace rmap {

/// Whether a file that begins with `text` means to be a LAS file, packed (LAZ) or not.
bool looks_like_las(std::string_view text);

/// Reads the points of a LAS file (ASPRS, versions 1.2 to 1.4, point formats 0 to 10): x, y, z
/// in the units of the file, whatever its coordinate system. Packed files (LAZ) are an
/// Error(input) that says how to unpack them.
void read_las(InputFile& file, const PointReadOptions& options, PointCloud& cloud);

}  // namespace rmap
