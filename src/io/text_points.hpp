#pragma once

#include "io/input_file.hpp"
#include "io/point_cloud.hpp"

namespace rmap {

/// Reads points as text, one a line: numbers separated by blanks, commas or semicolons, x, y
/// and z first; or a first line of names, by which they are found in any order. `#` and `//`
/// begin comments. A first line of one whole number is how many points follow.
void read_text_points(InputFile& file, const PointReadOptions& options, PointCloud& cloud);

}  // namespace rmap
