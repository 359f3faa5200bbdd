#include "io/text.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include <fmt/format.h>

namespace rmap {

namespace {

constexpr std::size_t kMaxQuoted = 40;

bool is_blank(char character) {
  return character == ' ' || character == '\t' || character == '\r' || character == '\v' ||
         character == '\f';
}

// from_chars takes no plus; "+-1" stays no number.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

template <class T>
std::errc parse(std::string_view word, T& value) {
  word = without_plus(word);
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  return code == std::errc() && end != word.data() + word.size() ? std::errc::invalid_argument
                                                                 : code;
}

template <class T>
std::optional<T> parsed(std::string_view word) {
  T value{};
  if (parse(word, value) != std::errc()) return std::nullopt;
  return value;
}

}  // namespace

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char character : text.substr(0, kMaxQuoted)) {
    const bool printable = character >= ' ' && character <= '~';
    if (printable) {
      result += character;
    } else {
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(character));
    }
  }
  return result + (text.size() > kMaxQuoted ? "...\"" : "\"");
}

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool LineReader::next() {
  if (offset_ >= text_.size()) return false;
  const std::string_view rest = text_.substr(offset_);
  const std::size_t length = rest.find('\n');
  line_ = rest.substr(0, length);
  offset_ = length == std::string_view::npos ? text_.size() : offset_ + length + 1;
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  ++number_;
  return true;
}

std::string_view next_word(std::string_view& text) {
  std::size_t begin = 0;
  while (begin < text.size() && is_blank(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && !is_blank(text[end])) ++end;
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

bool same_letters(std::string_view a, std::string_view b) {
  const auto lower = [](char character) {
    return character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a')
                                                : character;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char one, char other) { return lower(one) == lower(other); });
}

std::optional<double> parse_double(std::string_view word) { return parsed<double>(word); }

std::optional<std::uint64_t> parse_unsigned(std::string_view word) {
  return parsed<std::uint64_t>(word);
}

std::optional<float> parse_float(std::string_view word) {
  float value = 0;
  const std::errc code = parse(word, value);
  if (code == std::errc()) return value;
  if (code != std::errc::result_out_of_range) return std::nullopt;
  // A number, but not a float: as a double it rounds to what it is nearest to.
  const auto wide = parsed<double>(word);
  if (!wide) return std::nullopt;
  return static_cast<float>(*wide);
}

}  // namespace rmap
