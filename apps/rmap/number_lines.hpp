#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <istream>
#include <span>
#include <string>

namespace rmap::command {

/// Lines of numbers, separated by commas or blanks, from a file or, for the name "-",
/// from standard input. `#` starts a comment; lines without numbers are skipped. One line
/// at a time, so that a list may be longer than memory.
class NumberLines {
 public:
  /// Throws Error(io) when the file cannot be opened.
  explicit NumberLines(const std::filesystem::path& file);

  /// Fills `numbers` from the next line; false at the end. Throws Error(input) naming the
  /// line when it holds anything but as many numbers.
  bool next(std::span<double> numbers);

  /// Where the last numbers came from, for messages: "boxes.txt, line 3".
  std::string place() const;

 private:
  std::string name_;
  std::ifstream file_;
  std::istream* stream_;
  std::size_t line_ = 0;
};

}  // namespace rmap::command
