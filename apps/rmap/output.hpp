#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace rmap::command {

/// Writes to standard output. Throws Error(io) when it cannot take the text: a full
/// disk or a closed pipe.
void print(std::string_view text);

/// A table on standard output, whose header comes with its first row: a request that is
/// refused gets none.
class Table {
 public:
  explicit Table(std::string header) : header_(std::move(header)) {}

  /// Header and rows end with a line break. Throws as print().
  void row(std::string_view text);

 private:
  std::string header_;
};

/// Brings out what is still buffered. Throws as print().
void flush_output();

/// Whether people watch standard error: a terminal, no file or pipe.
bool error_is_terminal();

}  // namespace rmap::command
