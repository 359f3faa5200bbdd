#include "io/bag/crc32.hpp"

#include "support/bag_writer.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

std::span<const std::byte> bytes(const std::string& text) { return std::as_bytes(std::span(text)); }

TEST(Crc32, is_that_of_the_world) {
  EXPECT_EQ(crc32(bytes("123456789")), 0xCBF43926U);
  EXPECT_EQ(crc32({}), 0U);
}

TEST(Crc32, of_parts_is_that_of_the_whole_and_of_the_plain_twin) {
  test::Random random(32);
  SCOPED_TRACE(random.trace());
  for (int size = 0; size < 100; ++size) {
    std::string text;
    for (int i = 0; i < size; ++i) text += static_cast<char>(random.integer(0, 255));
    const auto cut = static_cast<std::size_t>(random.integer(0, size));
    Crc32 crc;
    crc.add(bytes(text).first(cut));
    crc.add(bytes(text).subspan(cut));
    EXPECT_EQ(crc.value(), test::plain_crc32(text)) << size;
  }
}

}  // namespace
}  // namespace rmap
