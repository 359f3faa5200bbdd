#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rmap {

/// Most bytes that one compressed piece of a bag may unpack to.
inline constexpr std::uint64_t kMostUnpacked = std::uint64_t{1} << 30;

/// How much a bag may unpack to, so that a small file can take neither much memory nor much
/// time: each piece 32 MiB and a hundred times its packed size, all so far 32 MiB and a thousand
/// times theirs.
class UnpackBudget {
 public:
  /// Throws Error(limit), without the place, when `packed` bytes that say that they unpack to
  /// `unpacked` bytes are too much.
  void take(std::uint64_t packed, std::uint64_t unpacked);

 private:
  std::uint64_t packed_ = 0;
  std::uint64_t unpacked_ = 0;
};

// These unpack frames into `content`, whose size they must have. False when they do not, or are
// damaged. No memory is taken by what a frame says of itself.

bool unpack_zstd(std::span<const std::byte> packed, std::span<std::byte> content);
bool unpack_lz4(std::span<const std::byte> packed, std::span<std::byte> content);

/// Whether a message is a frame of zstd instead of CDR, as rosbag2 makes it when it compresses
/// by message.
bool is_packed_message(std::span<const std::byte> message);

/// Unpacks such a message into `content`. Throws Error, without the message's name, when it is
/// damaged or beyond the budget.
void unpack_message(std::span<const std::byte> message, UnpackBudget& budget,
                    std::vector<std::byte>& content);

}  // namespace rmap
