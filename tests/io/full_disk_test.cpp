#include "io/atomic_file.hpp"
#include "io/cuboid_samples.hpp"
#include "io/files.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <functional>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/cell_files.hpp>
#include <rmap/cuboid_files.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {
namespace {

using test::expect_error;
using testing::ElementsAre;

// Every writer of the module, each with more than a small disk holds.
struct Writer {
  std::string name;
  std::function<void(const std::filesystem::path&)> write;
};

void write_many_cells(const std::filesystem::path& file) {
  write_cells(file, [](CellSink sink) {
    for (int i = 0; i < 50000; ++i) sink({.center = {0.1 * i, 0, 0}, .size = 0.1});
  });
}

void write_many_cuboids(const std::filesystem::path& file) {
  test::Random random(1);
  write_cuboids(file, test::random_cuboids(random, 10000));
}

std::vector<Writer> all_writers() {
  const auto points = [](const std::filesystem::path& file) {
    write_points(file, std::vector<Vector3f>(50000, Vector3f::Ones()));
  };
  const auto poses = [](const std::filesystem::path& file) {
    write_poses(file, std::vector<Pose>(20000, Pose::Identity()));
  };
  std::vector<Writer> writers = {{"a.bin", points},           {"a.pcd", points},
                                 {"poses.txt", poses},        {"a.csv", write_many_cells},
                                 {"a.ply", write_many_cells}, {"b.pcd", write_many_cells}};
  for (const char* ending :
       {".rcs", ".csv", ".json", ".ply", ".glb", ".urdf", ".sdf", ".xml", ".scene"}) {
    writers.push_back({std::string("cuboids") + ending, write_many_cuboids});
  }
  return writers;
}

TEST(FullDisk, is_an_error_that_names_file_and_reason) {
  const std::string sentence = "cannot write /dev/full: No space left on device";
  AtomicFile small("/dev/full");
  small.write("a little");  // buffered
  expect_error(ErrorKind::io, sentence, [&] { small.commit(); });
  AtomicFile large("/dev/full");
  expect_error(ErrorKind::io, sentence, [&] { large.write(std::string(1 << 20, 'x')); });
}

class Tmpfs {
 public:
  explicit Tmpfs(const std::filesystem::path& folder) : folder_(folder) {
    mounted_ = ::mount("tmpfs", folder_.c_str(), "tmpfs", 0, "size=64k") == 0;
  }
  Tmpfs(const Tmpfs&) = delete;
  Tmpfs& operator=(const Tmpfs&) = delete;
  ~Tmpfs() {
    if (mounted_) ::umount(folder_.c_str());
  }
  bool mounted() const { return mounted_; }

 private:
  std::filesystem::path folder_;
  bool mounted_;
};

TEST(FullDisk, leaves_the_old_file_and_nothing_else) {
  const test::TemporaryFolder folder;
  const Tmpfs disk(folder.path());
  if (!disk.mounted()) GTEST_SKIP() << "mounting a tmpfs: " << std::strerror(errno);
  int cases = 0;
  for (const Writer& writer : all_writers()) {
    const std::string file = folder / writer.name;
    test::write_text(file, "old");
    expect_error(ErrorKind::io, "cannot write " + file + ": No space left on device",
                 [&] { writer.write(file); });
    EXPECT_EQ(test::read_text(file), "old");
    EXPECT_THAT(folder.names(), ElementsAre(writer.name));
    std::filesystem::remove(file);
    ++cases;
  }
  EXPECT_EQ(cases, 15);
}

// What `writer` does in a process whose files must not grow beyond 4096 bytes; the exit
// code is 0 when it fails as it must.
int status_under_limit(const Writer& writer, const std::string& file) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{.rlim_cur = 4096, .rlim_max = 4096};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(2);
    try {
      writer.write(file);
    } catch (const Error& error) {
      const bool sound = error.kind() == ErrorKind::io &&
                         error.what() == "cannot write " + file + ": File too large";
      ::_exit(sound ? 0 : 3);
    }
    ::_exit(4);
  }
  int status = -1;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return status;
}

TEST(FullDisk, limit_of_the_size_of_files_is_the_same) {
  const test::TemporaryFolder folder;
  int cases = 0;
  for (const Writer& writer : all_writers()) {
    const std::string file = folder / writer.name;
    test::write_text(file, "old");
    EXPECT_EQ(status_under_limit(writer, file), 0) << writer.name;
    EXPECT_EQ(test::read_text(file), "old");
    EXPECT_THAT(folder.names(), ElementsAre(writer.name));
    std::filesystem::remove(file);
    ++cases;
  }
  EXPECT_EQ(cases, 15);
}

}  // namespace
}  // namespace rmap
