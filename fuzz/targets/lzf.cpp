// The first two bytes are the size that the rest must decompress to.
#include "io/lzf.hpp"

#include "support/input.hpp"

#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  // Copied, so that the sanitizer guards both ends of the input too.
  const auto bytes = std::as_bytes(std::span(data, size)).subspan(2);
  const std::vector<std::byte> input(bytes.begin(), bytes.end());
  std::vector<std::byte> output(data[0] + 256U * data[1]);
  if (rmap::decompress_lzf(input, output) && output.size() > rmap::kMaxLzfRatio * input.size()) {
    rmap::fuzz::fail("more bytes than kMaxLzfRatio allows");
  }
  return 0;
}
