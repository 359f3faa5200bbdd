#include "io/input_file.hpp"

#include "io/system_error.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

InputFile::InputFile(std::filesystem::path path) : path_(std::move(path)) {
  // Non-blocking, so that a pipe without a writer is refused instead of waited for.
  descriptor_ = FileDescriptor(::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!descriptor_.valid()) throw system_error("open", path_, errno);
  struct stat status {};
  if (::fstat(descriptor_.get(), &status) != 0) throw system_error("examine", path_, errno);
  if (!S_ISREG(status.st_mode)) {
    throw Error(ErrorKind::io,
                fmt::format("cannot read {}: it is {}, and must be a regular file", path_.string(),
                            S_ISDIR(status.st_mode) ? "a folder" : "a pipe or a device"));
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

void InputFile::read(std::span<std::byte> buffer) {
  read_at(position_, buffer);
  position_ += buffer.size();
}

std::vector<std::byte> InputFile::read_rest() {
  std::vector<std::byte> bytes(static_cast<std::size_t>(size_ - position_));
  read(bytes);
  return bytes;
}

std::vector<std::byte> InputFile::head(std::size_t most) const {
  std::vector<std::byte> bytes(static_cast<std::size_t>(std::min<std::uint64_t>(most, size_)));
  read_at(0, bytes);
  return bytes;
}

void InputFile::read_at(std::uint64_t offset, std::span<std::byte> buffer) const {
  while (!buffer.empty()) {
    const ssize_t count =
        ::pread(descriptor_.get(), buffer.data(), buffer.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw system_error("read", path_, errno);
    if (count == 0) {
      throw Error(ErrorKind::io, fmt::format("cannot read {}: it had {} bytes when it was opened "
                                             "and became shorter while it was read",
                                             path_.string(), size_));
    }
    buffer = buffer.subspan(static_cast<std::size_t>(count));
    offset += static_cast<std::uint64_t>(count);
  }
}

}  // namespace rmap
