#pragma once

#include <string_view>

namespace rmap::command {

/// Writes to standard output. Throws Error(io) when it cannot take the text: a full
/// disk or a closed pipe.
void print(std::string_view text);

/// Brings out what is still buffered. Throws as print().
void flush_output();

/// Whether people watch standard error: a terminal, no file or pipe.
bool error_is_terminal();

}  // namespace rmap::command
