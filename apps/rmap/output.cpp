#include "output.hpp"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <rmap/error.hpp>

namespace rmap::command {

namespace {

[[noreturn]] void fail(int code) {
  throw Error(ErrorKind::io,
              "cannot write to standard output: " + std::generic_category().message(code));
}

}  // namespace

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail(errno);
}

void Table::row(std::string_view text) {
  print(std::exchange(header_, {}));
  print(text);
}

void flush_output() {
  if (std::fflush(stdout) != 0) fail(errno);
}

bool error_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace rmap::command
