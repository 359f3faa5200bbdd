#pragma once

#include "io/bag/pose_messages.hpp"

#include <cstddef>
#include <span>
#include <vector>

#include <rmap/box.hpp>

namespace rmap {

/// The header of a sensor_msgs/PointCloud2 alone.
MessageHeader decode_cloud_header(std::span<const std::byte> message);

/// The points of a sensor_msgs/PointCloud2, row by row: the first elements of its fields x, y
/// and z, of any type and place, as floats. Points that are not finite stay in; coordinates
/// beyond float32 become infinite. Throws Error(input) without the message's name when its
/// sizes contradict one another, Error(limit) for more than kMaxPointsPerFile points.
void decode_cloud(std::span<const std::byte> message, std::vector<Vector3f>& points);

}  // namespace rmap
