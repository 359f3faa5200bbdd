#include "number_lines.hpp"

#include "arguments.hpp"

#include <array>
#include <cerrno>
#include <iostream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap::command {

namespace {

constexpr std::size_t kLongestLine = 4096;

}  // namespace

NumberLines::NumberLines(const std::filesystem::path& file)
    : name_(file == "-" ? "standard input" : file.string()), stream_(&std::cin) {
  if (file == "-") return;
  file_.open(file);
  if (!file_) {
    throw Error(ErrorKind::io,
                fmt::format("cannot open {}: {}", name_, std::generic_category().message(errno)));
  }
  stream_ = &file_;
}

bool NumberLines::next(std::span<double> numbers) {
  std::array<char, kLongestLine> buffer;
  while (stream_->getline(buffer.data(), buffer.size())) {
    ++line_;
    // The end of the line is counted, but for a last line without one.
    const auto read = static_cast<std::size_t>(stream_->gcount());
    std::string_view text(buffer.data(), stream_->eof() ? read : read - 1);
    if (text.find('\0') != std::string_view::npos) {
      throw Error(ErrorKind::input, fmt::format("{} holds a zero byte: it must be text", place()));
    }
    text = text.substr(0, text.find('#'));
    if (text.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    if (!parse_numbers(text, numbers)) {
      throw Error(ErrorKind::input, fmt::format("{} is \"{}\": it must be {} numbers, separated by "
                                                "commas or blanks",
                                                place(), text, numbers.size()));
    }
    return true;
  }
  if (stream_->bad()) {
    throw Error(ErrorKind::io, fmt::format("cannot read {} behind line {}", name_, line_));
  }
  if (!stream_->eof()) {
    ++line_;
    throw Error(ErrorKind::input,
                fmt::format("{} is longer than the {} characters that are allowed", place(),
                            kLongestLine - 1));
  }
  return false;
}

std::string NumberLines::place() const { return fmt::format("{}, line {}", name_, line_); }

}  // namespace rmap::command
