#include "io/bag/yaml_reader.hpp"

#include "io/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/error.hpp>

namespace rmap {
namespace {

using testing::ElementsAre;
using testing::Optional;

std::optional<std::vector<std::string>> texts_at(const std::string& text,
                                                 std::initializer_list<const char*> keys) {
  YamlReader yaml("f.yaml", text);
  std::optional<std::vector<std::string>> texts;
  bool found = true;
  for (const char* key : keys) found = found && yaml.enter_value(key);
  if (found) texts = yaml.read_texts();
  yaml.finish();
  return texts;
}

TEST(YamlReader, finds_lists_by_their_keys) {
  const std::string text =
      "other: [list, [of, {a: b}], lists]\n"
      "? [a, key]\n"
      ": and its value\n"
      "b: {c: {}, d: x}\n"
      "a:\n"
      "  - not: it\n"
      "root:\n"
      "  a: {b: [1]}\n"
      "  b:\n"
      "    - 'one''s'\n"
      "    - \"two\\n\"\n"
      "    - three\n"
      "tail: 1\n";
  EXPECT_THAT(texts_at(text, {"root", "b"}), Optional(ElementsAre("one's", "two\n", "three")));
  EXPECT_THAT(texts_at(text, {"root", "a", "b"}), Optional(ElementsAre("1")));
  EXPECT_EQ(texts_at(text, {"b", "c"}), std::nullopt);
  EXPECT_EQ(texts_at(text, {"b", "x"}), std::nullopt);
  EXPECT_EQ(texts_at(text, {"other"}), std::nullopt);
  EXPECT_EQ(texts_at(text, {"missing", "b"}), std::nullopt);
  EXPECT_EQ(texts_at("", {"a"}), std::nullopt);
  EXPECT_EQ(texts_at("a", {"a"}), std::nullopt);
  EXPECT_THAT(texts_at("[a, b]", {}), Optional(ElementsAre("a", "b")));
  EXPECT_THAT(texts_at("[]", {}), Optional(ElementsAre()));
}

TEST(YamlReader, says_what_is_wrong_and_where) {
  const auto expect = [](const std::string& text, const std::string& sentence) {
    test::expect_error(ErrorKind::input, "f.yaml" + sentence, [&] { texts_at(text, {"a"}); });
  };
  expect("a: 1\nb: [", ", line 3: did not find expected node content");
  expect("a: 1\nb: \x01", ", byte 8: control characters are not allowed");
  expect("a: &x 1", ", line 1: anchors and aliases are not allowed");
  expect("a: 1\nb: *x", ", line 2: anchors and aliases are not allowed");
  expect("a: 1\n%YAML 1.1\n", ": a line begins with %: directives are not allowed");
  expect("a: " + std::string(64, '['), ", line 1: nodes lie in more than 64 others");
  EXPECT_NO_THROW(texts_at(std::string(64, '[') + std::string(64, ']'), {}));
}

// A megabyte of what makes YAML slow takes no longer than other text.
TEST(YamlReader, hostile_texts_cost_no_more_than_others) {
  int refused = 0;
  for (const std::string piece : {"[",
                                  "{",
                                  "? ",
                                  "- ",
                                  "\xff",
                                  "&a ",
                                  "&a 1, ",
                                  "!a",
                                  "!a 1\n",
                                  "%TAG !a! b\n",
                                  "'",
                                  "\"",
                                  "|",
                                  ": ",
                                  "a:\n ",
                                  "#",
                                  "\"\\U0001F600",
                                  "--- a\n",
                                  "[1],",
                                  "a",
                                  "a: b\n",
                                  "- a\n",
                                  "\t",
                                  "[a: b, "}) {
    std::string text;
    while (text.size() < 1'000'000) text += piece;
    try {
      texts_at(text, {"x"});
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      ++refused;
    }
  }
  EXPECT_GT(refused, 10);
}

}  // namespace
}  // namespace rmap
