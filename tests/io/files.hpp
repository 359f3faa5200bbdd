#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rmap/box.hpp>
#include <rmap/error.hpp>

namespace rmap::test {

/// A new folder that is removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }
  /// Names of all that is in it, hidden files too, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

void write_text(const std::filesystem::path& file, std::string_view text);
std::string read_text(const std::filesystem::path& file);

/// The bytes of numbers, little-endian, as a string.
std::string bytes_of(std::span<const float> numbers);
std::string bytes_of(std::span<const Vector3f> points);
template <class T>
std::string raw(T number) {
  return {reinterpret_cast<const char*>(&number), sizeof(T)};
}

/// `call` must throw an Error of this kind with exactly this sentence.
void expect_error(ErrorKind kind, const std::string& sentence, const std::function<void()>& call);

/// Whether the points are the same bit for bit, NaN included.
bool same_bits(std::span<const Vector3f> a, std::span<const Vector3f> b);

/// Points of all kinds: usual, huge, tiny, zero of both signs, not finite.
std::vector<Vector3f> nasty_points();

/// A file or folder of the real data; empty where these are missing.
std::filesystem::path real_data(const std::filesystem::path& name);

}  // namespace rmap::test
