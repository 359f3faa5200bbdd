#pragma once

#include "io/input_file.hpp"
#include "io/point_cloud.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include <rmap/box.hpp>

namespace rmap {

/// KITTI's form of a scan: little-endian float32 x, y, z, intensity, 16 bytes a point,
/// nothing else.

/// Reads the points in pieces, so that no second copy is in memory; the columns of
/// `options`, where it has any, take the place of these. Throws Error(input) when the size is
/// 0 or no multiple of that of a point.
void read_bin(InputFile& file, const PointReadOptions& options, PointCloud& cloud);

/// Throws unless the file holds a whole number of points, at least one and not too many.
/// `columns` describes a point in the message.
void check_bin_size(const InputFile& file, std::string_view columns, std::size_t point_size);

/// Writes at least one point, intensity 0; none is an Error(input).
void write_bin(const std::filesystem::path& file, std::span<const Vector3f> points);

}  // namespace rmap
