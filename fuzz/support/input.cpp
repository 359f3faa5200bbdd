#include "support/input.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <unistd.h>

#include <rmap/error.hpp>

namespace rmap::fuzz {

namespace {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = std::filesystem::temp_directory_path() / "rmap-fuzz-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

void fail(const std::string& sentence) {
  std::fprintf(stderr, "finding: %s\n", sentence.c_str());
  std::abort();
}

std::filesystem::path write_file(std::string_view bytes, const std::string& name) {
  static const TemporaryFolder kFolder;
  std::filesystem::path file = kFolder.path() / name;
  // Overwriting would have some file systems wait for the disk.
  std::filesystem::remove(file);
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
  return file;
}

bool is_sound(const std::filesystem::path& file, FunctionRef<void()> read) {
  try {
    read();
    return true;
  } catch (const Error& error) {
    const std::string sentence = error.what();
    if (error.kind() != ErrorKind::input && error.kind() != ErrorKind::limit) {
      fail("an error of the wrong kind: " + sentence);
    }
    if (sentence.find(file.string()) == std::string::npos) {
      fail("an error that does not name the file: " + sentence);
    }
    return false;
  }
}

}  // namespace rmap::fuzz
