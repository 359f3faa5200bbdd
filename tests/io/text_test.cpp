#include "io/text.hpp"

#include "support/random.hpp"

#include <clocale>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rmap {
namespace {

struct NumberCase {
  std::string_view word;
  std::optional<double> value;
};

TEST(Text, parses_numbers_of_every_spelling) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<NumberCase> cases = {{"0", 0.0},
                                         {"-1.5", -1.5},
                                         {"+1", 1.0},
                                         {"+.5", 0.5},
                                         {"5.", 5.0},
                                         {"1e3", 1000.0},
                                         {"1E+3", 1000.0},
                                         {"-2.5e-3", -0.0025},
                                         {"inf", infinity},
                                         {"+inf", infinity},
                                         {"-Inf", -infinity},
                                         {"infinity", infinity},
                                         {"", std::nullopt},
                                         {"+", std::nullopt},
                                         {"-", std::nullopt},
                                         {"+-1", std::nullopt},
                                         {"++1", std::nullopt},
                                         {"1,5", std::nullopt},
                                         {"1.5x", std::nullopt},
                                         {"0x10", std::nullopt},
                                         {"abc", std::nullopt},
                                         {"1e", std::nullopt},
                                         {"1e400", std::nullopt},
                                         {" 1", std::nullopt}};
  for (const NumberCase& number : cases) {
    EXPECT_EQ(parse_double(number.word), number.value) << number.word;
  }
  for (const std::string_view word : {"nan", "NaN", "-nan", "+nan"}) {
    const auto value = parse_double(word);
    ASSERT_TRUE(value) << word;
    EXPECT_TRUE(std::isnan(*value)) << word;
  }
}

TEST(Text, parses_what_was_printed) {
  test::Random random(1);
  SCOPED_TRACE(random.trace());
  int cases = 0;
  for (; cases < 2000; ++cases) {
    const double value = random.real(-1, 1) * std::pow(10.0, random.integer(-30, 30));
    ASSERT_EQ(parse_double(fmt::format("{:.17g}", value)), value);
    const auto narrow = static_cast<float>(value);
    ASSERT_EQ(parse_float(fmt::format("{:.9g}", narrow)), narrow);
  }
  EXPECT_EQ(cases, 2000);
}

TEST(Text, floats_beyond_the_range_go_to_infinity_or_zero) {
  EXPECT_EQ(parse_float("1e39"), std::numeric_limits<float>::infinity());
  EXPECT_EQ(parse_float("-1e300"), -std::numeric_limits<float>::infinity());
  EXPECT_EQ(parse_float("1e-60"), 0.0F);
  EXPECT_EQ(parse_float("1e400"), std::nullopt);
  EXPECT_EQ(parse_float("1.0.0"), std::nullopt);
}

TEST(Text, parses_whole_numbers_to_the_limit) {
  EXPECT_EQ(parse_unsigned("18446744073709551615"), 18446744073709551615u);
  for (const std::string_view word : {"18446744073709551616", "-1", "1.0", "", "12a"}) {
    EXPECT_EQ(parse_unsigned(word), std::nullopt) << word;
  }
}

TEST(Text, splits_words_at_blanks_of_all_kinds) {
  std::string_view text = "  one\ttwo \v\f three\r";
  std::vector<std::string_view> words;
  for (auto word = next_word(text); !word.empty(); word = next_word(text)) words.push_back(word);
  EXPECT_THAT(words, testing::ElementsAre("one", "two", "three"));
}

TEST(Text, lines_end_with_either_end_or_none) {
  LineReader lines("a\r\n\nbc\nd");
  std::vector<std::string_view> found;
  std::vector<std::size_t> offsets;
  while (lines.next()) {
    found.push_back(lines.line());
    offsets.push_back(lines.offset());
    EXPECT_EQ(lines.number(), found.size());
  }
  EXPECT_THAT(found, testing::ElementsAre("a", "", "bc", "d"));
  EXPECT_THAT(offsets, testing::ElementsAre(3u, 4u, 7u, 8u));
  EXPECT_FALSE(LineReader("").next());
}

TEST(Text, quotes_what_cannot_be_printed) {
  EXPECT_EQ(in_quotes("x y"), "\"x y\"");
  EXPECT_EQ(in_quotes(std::string_view("\0\n\xff", 3)), "\"\\x00\\x0a\\xff\"");
  EXPECT_EQ(in_quotes(std::string(41, 'a')), fmt::format("\"{:a<40}...\"", ""));
}

}  // namespace
}  // namespace rmap
