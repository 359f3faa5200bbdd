#pragma once

#include <stdexcept>
#include <string>

namespace rmap {

/// What went wrong, for programs that react to an error instead of showing it.
enum class ErrorKind {
  input,  ///< a file, a point or an option is not what it must be
  limit,  ///< a value is beyond what a map can hold
  io,     ///< the operating system refused to read or write
  usage,  ///< a call that makes no sense in the state the object is in
};

/// Every failure that the library reports. `what()` is one complete sentence
/// that names the file, the place, the value and what is allowed.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& sentence) : std::runtime_error(sentence), kind_(kind) {}

  ErrorKind kind() const noexcept { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace rmap
