#include "io/byte_reader.hpp"

#include "io/files.hpp"

#include <array>
#include <limits>

#include <gtest/gtest.h>

namespace rmap {
namespace {

TEST(Bytes, numbers_are_little_endian) {
  const auto bytes = little_endian(std::uint32_t{0x01020304});
  EXPECT_EQ(bytes, (std::array{std::byte{4}, std::byte{3}, std::byte{2}, std::byte{1}}));
  EXPECT_EQ(load_little<std::uint32_t>(bytes.data()), 0x01020304u);
  EXPECT_EQ(load_little<double>(little_endian(-1.25).data()), -1.25);
}

TEST(ByteReader, reads_numbers_and_bytes_in_turn) {
  const std::string text = std::string("ab") + test::raw(std::uint16_t{513}) + test::raw(2.5F);
  ByteReader reader("x.rmap", std::as_bytes(std::span(text)), 100);
  EXPECT_EQ(reader.take(2, "letters").size(), 2u);
  EXPECT_EQ(reader.offset(), 102u);
  EXPECT_EQ(reader.number<std::uint16_t>("a number"), 513);
  EXPECT_EQ(reader.number<float>("a number"), 2.5F);
  EXPECT_EQ(reader.remaining(), 0u);
  EXPECT_TRUE(reader.take(0, "nothing").empty());
}

TEST(ByteReader, names_where_the_bytes_end) {
  const std::array<std::byte, 6> bytes = {};
  ByteReader reader("x.rmap", bytes, 10);
  reader.take(4, "the magic");
  test::expect_error(ErrorKind::input,
                     "x.rmap is cut off: the size at byte 14 takes 4 bytes, and 2 are left",
                     [&] { reader.number<std::uint32_t>("the size"); });
  // As much as can be announced: no overflow, and the reader stays where it is.
  test::expect_error(
      ErrorKind::input,
      "x.rmap is cut off: a chunk at byte 14 takes 18446744073709551615 bytes, and 2 are left",
      [&] { reader.take(std::numeric_limits<std::uint64_t>::max(), "a chunk"); });
  EXPECT_EQ(reader.take(2, "the rest").size(), 2u);
}

}  // namespace
}  // namespace rmap
