#pragma once

#include "io/input_file.hpp"
#include "io/point_cloud.hpp"

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include <rmap/box.hpp>

namespace rmap {

/// Reads all points of a PCD file: any order, types and sizes of fields, ascii, binary,
/// binary_compressed. A VIEWPOINT other than the identity is the sensor's pose. The data must have
/// exactly the length that the header announces, up to 64 KiB of zeros behind binary data aside;
/// that is checked before memory is taken.
void read_pcd(InputFile& file, const PointReadOptions& options, PointCloud& cloud);

/// Writes the points as binary float32 x y z.
void write_pcd(const std::filesystem::path& file, std::span<const Vector3f> points);

/// The header of a binary PCD file of `points` points with float32 fields of these names.
/// As long for any number of points, so that it can be replaced when the number is known.
std::string pcd_header_text(std::initializer_list<std::string_view> fields, std::uint64_t points);

}  // namespace rmap
