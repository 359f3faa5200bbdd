#pragma once

#include "io/input_file.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include <rmap/box.hpp>

namespace rmap {

/// KITTI's form of a scan: little-endian float32 x, y, z, intensity, 16 bytes a point,
/// nothing else.

/// Reads the points into `points`, in pieces, so that no second copy is in memory.
/// Throws Error(input) when the size is 0 or no multiple of 16.
void read_bin(InputFile& file, std::vector<Vector3f>& points);

/// Writes at least one point, intensity 0; none is an Error(input).
void write_bin(const std::filesystem::path& file, std::span<const Vector3f> points);

}  // namespace rmap
