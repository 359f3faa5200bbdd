#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rmap {

/// Text as it may stand in a message: in quotes, what is not printable escaped,
/// cut off after some 40 characters.
std::string in_quotes(std::string_view text);

/// Bytes as text.
std::string_view as_text(std::span<const std::byte> bytes);

/// The lines of a text, without their ends ("\n" or "\r\n").
class LineReader {
 public:
  explicit LineReader(std::string_view text) : text_(text) {}

  /// Goes to the next line; false at the end.
  bool next();
  std::string_view line() const { return line_; }
  /// Number of the line, from 1.
  std::size_t number() const { return number_; }
  /// Offset in the text of the byte behind the line and its end.
  std::size_t offset() const { return offset_; }

 private:
  std::string_view text_;
  std::string_view line_;
  std::size_t number_ = 0;
  std::size_t offset_ = 0;
};

/// Takes the first word off `text`, words being separated by blanks and tabs; empty
/// when there is none.
std::string_view next_word(std::string_view& text);

/// Whether two words are the same but for capital letters of ASCII.
bool same_letters(std::string_view a, std::string_view b);

/// The number that is the whole of `word`, whatever the locale: also with a plus, as nan
/// or inf. Nothing when it is none, or beyond the type.
std::optional<double> parse_double(std::string_view word);
std::optional<std::uint64_t> parse_unsigned(std::string_view word);

/// As parse_double, rounded once to float: beyond its range to infinity or zero.
std::optional<float> parse_float(std::string_view word);

}  // namespace rmap
