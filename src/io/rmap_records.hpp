#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <rmap/grid.hpp>

/// The contents of the small chunks of a `.rmap` file. What decodes throws Error(input)
/// with what is wrong as a predicate ("has 3 bytes: ..."), for the reader to complete.
namespace rmap::wire {

/// OPTS: the options that are part of the map.
std::vector<std::byte> encoded_options(const Options& options);
/// The other options have their defaults. Only what the wire alone forbids is checked.
Options decoded_options(std::span<const std::byte> content);

/// HIST.
std::vector<std::byte> encoded_history(History history);
History decoded_history(std::span<const std::byte> content);

/// POSE: the poses of some scans that follow one another.
std::vector<std::byte> encoded_poses(std::span<const Pose> poses);
/// Appends to `poses`; each has passed check_pose. `stored_size` is what the content takes in the
/// file.
void decode_poses(std::span<const std::byte> content, std::uint64_t stored_size,
                  std::vector<Pose>& poses);

}  // namespace rmap::wire
