#pragma once

#include <cstddef>
#include <span>

namespace rmap {

/// Output bytes that LZF can make of one input byte at most: a reference of 3 bytes
/// repeats up to 264.
inline constexpr std::size_t kMaxLzfRatio = 88;

/// Decompresses LZF (M. Lehmann's liblzf, the compression of PCD). True when `input` is
/// sound and gives exactly the bytes that `output` has room for. Whatever the input,
/// nothing is read or written beyond the two.
bool decompress_lzf(std::span<const std::byte> input, std::span<std::byte> output);

}  // namespace rmap
