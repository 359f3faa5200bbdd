#include "io/atomic_file.hpp"

#include "io/system_error.hpp"

#include <cassert>
#include <cerrno>
#include <fcntl.h>
#include <optional>
#include <string>
#include <sys/stat.h>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 18;
constexpr int kMaxLinks = 40;             // as the kernel
constexpr int kMaxTemporaryNames = 1000;  // left by crashed processes, or in use beside us

constexpr std::string_view kWrite = "write";

// The file behind all links, which need not exist yet; nothing when the way leads
// through /proc, that is to a descriptor that is open already.
std::optional<std::filesystem::path> behind_links(const std::filesystem::path& target) {
  std::filesystem::path path = target;
  for (int links = 0; links < kMaxLinks; ++links) {
    if (path.native().starts_with("/proc/")) return std::nullopt;
    std::error_code not_a_link;
    const std::filesystem::path next = std::filesystem::read_symlink(path, not_a_link);
    if (not_a_link) return path;
    path = path.parent_path() / next;
  }
  throw system_error(kWrite, target, ELOOP);
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

// Writes all bytes at the descriptor's place; the error number, or 0.
int write_all(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return 0;
}

// Without it a crash could undo the rename. Some file systems cannot, and the new
// file is in place by now: no reason to fail.
void sync_folder(const std::filesystem::path& folder) {
  const FileDescriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.valid()) ::fsync(descriptor.get());
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path target) : target_(std::move(target)) {
  if (target_.empty()) throw Error(ErrorKind::input, "the file to write has no name");
  buffer_.reserve(kBufferSize);
  struct stat status {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  const auto destination = behind_links(target_);
  if (!destination || (exists && !S_ISREG(status.st_mode))) {
    descriptor_ = FileDescriptor(::open(target_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
    if (!descriptor_.valid()) fail(errno);
  } else {
    if (exists && ::access(target_.c_str(), W_OK) != 0) fail(errno);
    open_temporary(*destination);
    if (exists) {
      // File systems without permissions refuse this, and need it not.
      [[maybe_unused]] const int ignored = ::fchmod(descriptor_.get(), status.st_mode & 0777);
    }
  }
}

AtomicFile::~AtomicFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::open_temporary(const std::filesystem::path& destination) {
  destination_ = destination;
  if (!destination_.has_filename()) fail(EISDIR);
  for (int number = 0; number < kMaxTemporaryNames; ++number) {
    // Short whatever the target's name, which may be as long as names can be.
    std::filesystem::path name =
        folder_of(destination_) / fmt::format(".rmap-{}-{}.tmp", ::getpid(), number);
    descriptor_ =
        FileDescriptor(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (descriptor_.valid()) {
      temporary_ = std::move(name);
      return;
    }
    if (errno != EEXIST) break;
  }
  fail(errno);
}

void AtomicFile::write(std::span<const std::byte> bytes) {
  assert(descriptor_.valid());
  if (bytes.size() > kBufferSize - buffer_.size()) flush();
  if (bytes.size() < kBufferSize) {
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    return;
  }
  if (const int code = write_all(descriptor_.get(), bytes)) fail(code);
  flushed_ += bytes.size();
}

void AtomicFile::overwrite(std::uint64_t offset, std::span<const std::byte> bytes) {
  assert(offset + bytes.size() <= size());
  flush();
  if (temporary_.empty()) fail(ESPIPE);
  if (::lseek(descriptor_.get(), static_cast<off_t>(offset), SEEK_SET) < 0) fail(errno);
  if (const int code = write_all(descriptor_.get(), bytes)) fail(code);
  if (::lseek(descriptor_.get(), static_cast<off_t>(flushed_), SEEK_SET) < 0) fail(errno);
}

void AtomicFile::flush() {
  assert(descriptor_.valid());
  if (const int code = write_all(descriptor_.get(), buffer_)) fail(code);
  flushed_ += buffer_.size();
  buffer_.clear();
}

void AtomicFile::commit() {
  flush();
  const bool direct = temporary_.empty();
  // A pipe or a terminal has no disk behind it (EINVAL, EROFS, ENOTSUP).
  if (::fsync(descriptor_.get()) != 0 && !direct) fail(errno);
  // Network file systems report what went wrong as late as here.
  if (::close(descriptor_.release()) != 0) fail(errno);
  if (direct) return;
  if (::rename(temporary_.c_str(), destination_.c_str()) != 0) fail(errno);
  temporary_.clear();
  sync_folder(folder_of(destination_));
}

void AtomicFile::fail(int code) const { throw system_error(kWrite, target_, code); }

}  // namespace rmap
