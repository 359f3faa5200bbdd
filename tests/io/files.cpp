#include "io/files.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <unistd.h>

#include <gtest/gtest.h>

namespace rmap::test {

static_assert(std::endian::native == std::endian::little);

TemporaryFolder::TemporaryFolder() {
  std::string name = std::filesystem::temp_directory_path() / "rmap-test-XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> TemporaryFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_)) {
    names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

void write_text(const std::filesystem::path& file, std::string_view text) {
  // Overwriting would have some file systems wait for the disk.
  std::filesystem::remove(file);
  std::ofstream stream(file, std::ios::binary);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string bytes_of(std::span<const float> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

std::string bytes_of(std::span<const Vector3f> points) {
  return {reinterpret_cast<const char*>(points.data()), points.size_bytes()};
}

void expect_error(ErrorKind kind, const std::string& sentence, const std::function<void()>& call) {
  try {
    call();
    ADD_FAILURE() << "no error, where this was expected: " << sentence;
  } catch (const Error& error) {
    EXPECT_EQ(error.what(), sentence);
    EXPECT_EQ(error.kind(), kind) << sentence;
  }
}

bool same_bits(std::span<const Vector3f> a, std::span<const Vector3f> b) {
  return bytes_of(a) == bytes_of(b);
}

std::vector<Vector3f> nasty_points() {
  using Limits = std::numeric_limits<float>;
  return {{1.5F, -2.25F, 0.1F},
          {0, -0.0F, 1e-30F},
          {Limits::max(), Limits::lowest(), Limits::denorm_min()},
          {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()},
          {-80.1234567F, 3, Limits::epsilon()}};
}

std::filesystem::path real_data(const std::filesystem::path& name) {
  const char* chosen = std::getenv("RMAP_DATA");
  const std::filesystem::path path =
      std::filesystem::path(chosen == nullptr ? RMAP_DEFAULT_DATA : chosen) / name;
  return std::filesystem::exists(path) ? path : std::filesystem::path();
}

}  // namespace rmap::test
