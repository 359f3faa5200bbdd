#include "io/lzf.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using Bytes = std::vector<std::byte>;

Bytes bytes(std::initializer_list<int> values) {
  Bytes result;
  for (const int value : values) result.push_back(static_cast<std::byte>(value));
  return result;
}

// A plain encoder: the longest match within reach of the last place where the same three
// bytes stood, else a literal.
Bytes compress(const Bytes& input) {
  Bytes output;
  Bytes literals;
  const auto flush = [&] {
    if (literals.empty()) return;
    output.push_back(static_cast<std::byte>(literals.size() - 1));
    output.insert(output.end(), literals.begin(), literals.end());
    literals.clear();
  };
  std::map<std::array<std::byte, 3>, std::size_t> last;
  std::size_t at = 0;
  while (at < input.size()) {
    std::size_t length = 0;
    std::size_t distance = 0;
    if (at + 3 <= input.size()) {
      const std::array key{input[at], input[at + 1], input[at + 2]};
      const auto found = last.find(key);
      if (found != last.end() && at - found->second <= 8192) {
        distance = at - found->second;
        while (length < 264 && at + length < input.size() &&
               input[at + length] == input[at + length - distance]) {
          ++length;
        }
      }
      last[key] = at;
    }
    if (length < 3) {
      literals.push_back(input[at++]);
      if (literals.size() == 32) flush();
      continue;
    }
    flush();
    const std::size_t back = distance - 1;
    if (length - 2 < 7) {
      output.push_back(static_cast<std::byte>(((length - 2) << 5) | (back >> 8)));
    } else {
      output.push_back(static_cast<std::byte>((7u << 5) | (back >> 8)));
      output.push_back(static_cast<std::byte>(length - 9));
    }
    output.push_back(static_cast<std::byte>(back & 255));
    at += length;
  }
  flush();
  return output;
}

Bytes random_bytes(test::Random& random) {
  Bytes data(static_cast<std::size_t>(random.integer(0, 3000)));
  const int alphabet = random.integer(0, 3);
  for (auto& byte : data) byte = static_cast<std::byte>(random.integer(0, alphabet));
  return data;
}

TEST(Lzf, decompresses_by_hand) {
  Bytes output(10);
  // "ab" as it is, then 8 bytes from 2 back, which reaches into what it writes.
  ASSERT_TRUE(decompress_lzf(bytes({1, 'a', 'b', (6 << 5), 1}), output));
  EXPECT_EQ(std::memcmp(output.data(), "ababababab", 10), 0);
  // The longest reference: 264 bytes.
  output.resize(265);
  ASSERT_TRUE(decompress_lzf(bytes({0, 'z', (7 << 5), 255, 0}), output));
  EXPECT_EQ(output, Bytes(265, std::byte{'z'}));
  output.clear();
  EXPECT_TRUE(decompress_lzf({}, output));
}

TEST(Lzf, undoes_compression) {
  test::Random random(3);
  SCOPED_TRACE(random.trace());
  int cases = 0;
  std::size_t saved = 0;
  for (; cases < 200; ++cases) {
    const Bytes data = random_bytes(random);
    const Bytes compressed = compress(data);
    saved += data.size() - std::min(data.size(), compressed.size());
    Bytes output(data.size());
    ASSERT_TRUE(decompress_lzf(compressed, output));
    ASSERT_EQ(output, data);
  }
  EXPECT_EQ(cases, 200);
  EXPECT_GT(saved, 100000u);
}

TEST(Lzf, refuses_what_does_not_fill_the_output_exactly) {
  const Bytes compressed = compress(Bytes(500, std::byte{7}));
  for (const std::size_t size : {std::size_t{0}, std::size_t{499}, std::size_t{501}}) {
    Bytes output(size);
    EXPECT_FALSE(decompress_lzf(compressed, output)) << size;
  }
  Bytes output(500);
  EXPECT_TRUE(decompress_lzf(compressed, output));
}

TEST(Lzf, refuses_references_out_of_bounds_and_cut_input) {
  Bytes output(20);
  EXPECT_FALSE(decompress_lzf(bytes({(1 << 5), 0}), output));          // before the start
  EXPECT_FALSE(decompress_lzf(bytes({0, 'a', (1 << 5), 1}), output));  // one before the start
  EXPECT_FALSE(decompress_lzf(bytes({19, 'a', 'b'}), output));         // literals cut
  EXPECT_FALSE(decompress_lzf(bytes({0, 'a', (1 << 5)}), output));     // distance cut
  EXPECT_FALSE(decompress_lzf(bytes({0, 'a', (7 << 5)}), output));     // length cut
}

TEST(Lzf, survives_any_bytes) {
  test::Random random(4);
  SCOPED_TRACE(random.trace());
  int cases = 0;
  for (; cases < 20000; ++cases) {
    Bytes input(static_cast<std::size_t>(random.integer(0, 40)));
    for (auto& byte : input) byte = static_cast<std::byte>(random.integer(0, 255));
    Bytes output(static_cast<std::size_t>(random.integer(0, 200)));
    decompress_lzf(input, output);  // sanitizers watch the bounds
    ASSERT_LE(output.size(), 200u);
  }
  EXPECT_EQ(cases, 20000);
}

}  // namespace
}  // namespace rmap
