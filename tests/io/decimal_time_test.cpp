#include "io/decimal_time.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace rmap {
namespace {

TEST(DecimalTime, is_exact_to_the_nanosecond) {
  EXPECT_EQ(parse_time("1690309709.284305601"), 1690309709284305601);
  EXPECT_EQ(parse_time("0"), 0);
  EXPECT_EQ(parse_time("-1.5"), -1500000000);
  EXPECT_EQ(parse_time("+.000000001"), 1);
  EXPECT_EQ(parse_time("7."), 7000000000);
  EXPECT_EQ(parse_time("1.036224e-01"), 103622400);
  EXPECT_EQ(parse_time("1.305031102175300000e+09"), 1305031102175300000);
  EXPECT_EQ(parse_time("12E2"), 1200000000000);
  EXPECT_EQ(parse_time("0e9999"), 0);
  EXPECT_EQ(parse_time("1e-9999"), 0);
  EXPECT_EQ(parse_time("9223372036.854775807"), std::numeric_limits<std::int64_t>::max());
}

TEST(DecimalTime, rounds_what_is_finer) {
  EXPECT_EQ(parse_time("0.0000000014"), 1);
  EXPECT_EQ(parse_time("0.0000000015"), 2);
  EXPECT_EQ(parse_time("9e-10"), 1);
  EXPECT_EQ(parse_time("-0.0000000005"), -1);
}

TEST(DecimalTime, refuses_what_is_none) {
  for (const char* word : {"", "-", ".", "nan", "inf", "1.2.3", "1e", "1e+-3", "0x10", "1 ", "--1",
                           "9223372036.854775808", "1e10", "1e99999999999"}) {
    EXPECT_FALSE(parse_time(word)) << word;
  }
}

TEST(DecimalTime, is_written_as_it_is_read) {
  for (const std::int64_t time :
       {std::int64_t{0}, std::int64_t{1}, std::int64_t{-1500000000},
        std::numeric_limits<std::int64_t>::max(), -std::numeric_limits<std::int64_t>::max()}) {
    EXPECT_EQ(parse_time(time_text(time)), time);
  }
  EXPECT_EQ(time_text(std::numeric_limits<std::int64_t>::min()), "-9223372036.854775808");
}

}  // namespace
}  // namespace rmap
