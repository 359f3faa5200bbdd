#include "io/lzf.hpp"

#include <cstdint>
#include <cstring>

namespace rmap {

bool decompress_lzf(std::span<const std::byte> input, std::span<std::byte> output) {
  std::size_t in = 0;
  std::size_t out = 0;
  while (in < input.size()) {
    const auto control = static_cast<std::uint8_t>(input[in++]);
    if (control < 32) {  // that many bytes and one follow as they are
      const std::size_t count = control + std::size_t{1};
      if (count > input.size() - in || count > output.size() - out) return false;
      std::memcpy(output.data() + out, input.data() + in, count);
      in += count;
      out += count;
      continue;
    }
    // A reference: 3 bits of length, of which 7 means that a byte with more follows,
    // and 13 bits of distance back.
    std::size_t count = (control >> 5) + std::size_t{2};
    if (count == 9) {
      if (in == input.size()) return false;
      count += static_cast<std::uint8_t>(input[in++]);
    }
    if (in == input.size()) return false;
    const std::size_t distance =
        ((control & 31u) << 8) + static_cast<std::uint8_t>(input[in++]) + std::size_t{1};
    if (distance > out || count > output.size() - out) return false;
    // Byte by byte: what is copied may reach into what the copy makes.
    for (std::size_t i = 0; i < count; ++i, ++out) output[out] = output[out - distance];
  }
  return out == output.size();
}

}  // namespace rmap
