// Lines, words and numbers of the readers of text.
#include "io/text.hpp"

#include "support/input.hpp"

#include <cmath>

#include <fmt/format.h>

namespace rmap::fuzz {
namespace {

void check_number(std::string_view word) {
  const auto number = parse_double(word);
  const auto rounded = parse_float(word);
  if (number && !rounded) fail("a double that is no float");
  if (number && std::isfinite(*number) && parse_double(fmt::format("{}", *number)) != number) {
    fail("a double does not come back");
  }
  const auto count = parse_unsigned(word);
  if (count && parse_unsigned(fmt::format("{}", *count)) != count) fail("a count is another one");
}

void fuzz_text(std::string_view text) {
  LineReader lines(text);
  std::size_t number = 0;
  std::size_t offset = 0;
  while (lines.next()) {
    if (lines.number() != ++number) fail("a line is counted twice");
    if (lines.offset() <= offset || lines.offset() > text.size()) fail("a line takes no room");
    offset = lines.offset();
    std::string_view rest = lines.line();
    for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) check_number(word);
    for (const char character : in_quotes(lines.line())) {
      if (character < ' ' || character > '~') fail("a quotation that cannot be printed");
    }
  }
  if (offset != text.size()) fail("a text is not read to its end");
}

}  // namespace
}  // namespace rmap::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rmap::fuzz::fuzz_text(rmap::fuzz::text_of(data, size));
  return 0;
}
