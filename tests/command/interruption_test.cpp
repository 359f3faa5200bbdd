#include "command/command.hpp"

#include <array>
#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace rmap::test {

namespace {

constexpr int kExitAfterSighup = 129;
constexpr int kExitAfterSigint = 130;
constexpr int kExitAfterSigterm = 143;

class Interruption : public CommandTest {
 protected:
  Interruption() { simulate_room("room", 1); }

  // One scan under so many names that a build of them does not end before the test.
  void make_endless_folder(const std::string& name) const {
    constexpr int kScans = 5000;
    std::filesystem::create_directory(folder() / name);
    std::string poses;
    for (int i = 0; i < kScans; ++i) {
      std::filesystem::create_symlink("../room/000000.bin",
                                      folder() / name / fmt::format("{:06}.bin", i));
      poses += "1 0 0 0 0 1 0 0 0 0 1 0\n";
    }
    write(std::filesystem::path(name) / "poses.txt", poses);
  }
};

TEST_F(Interruption, OfABuildLeavesNoFile) {
  make_endless_folder("endless");
  const auto before = listing();
  for (const auto& [signal, exit_code] :
       {std::pair(SIGHUP, kExitAfterSighup), std::pair(SIGINT, kExitAfterSigint),
        std::pair(SIGTERM, kExitAfterSigterm)}) {
    RunningCommand running(folder(),
                           {"build", "endless", "-o", "endless.rmap", "--resolution", "0.1"});
    ASSERT_TRUE(running.wait_for("preparing: "));
    running.send(signal);
    EXPECT_EQ(running.wait(), exit_code);
    EXPECT_EQ(listing(), before);
  }
}

TEST_F(Interruption, OfAConversionLeavesNoFolder) {
  make_endless_folder("endless");
  const auto before = listing();
  RunningCommand running(folder(), {"convert", "endless", "copy", "--format", "pcd"});
  ASSERT_TRUE(running.wait_for("converting: "));
  running.send(SIGINT);
  EXPECT_EQ(running.wait(), kExitAfterSigint);
  EXPECT_EQ(listing(), before);
}

TEST_F(Interruption, OfASimulationLeavesNoFolder) {
  const auto before = listing();
  RunningCommand running(folder(), {"simulate", "campus", "--scans", "100000", "-o", "campus"});
  ASSERT_TRUE(running.wait_for("simulating: "));
  running.send(SIGTERM);
  EXPECT_EQ(running.wait(), kExitAfterSigterm);
  EXPECT_EQ(listing(), before);
}

// A small pipe takes the map only as it is read: so the signal comes in the middle of the write.
TEST_F(Interruption, LetsAFileBeCompleted) {
  constexpr int kPipeCapacity = 4096;
  rmap_done({"build", "room", "-o", "room.rmap", "--resolution", "0.02"});
  const std::string expected = bytes("room.rmap");
  ASSERT_GT(expected.size(), std::size_t{kPipeCapacity});
  const std::filesystem::path pipe = folder() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int both_ends = ::open(pipe.c_str(), O_RDWR | O_CLOEXEC);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(::fcntl(both_ends, F_SETPIPE_SZ, kPipeCapacity), kPipeCapacity);

  RunningCommand running(folder(), {"build", "room", "-o", "pipe", "--resolution", "0.02"});
  std::string received(1, '\0');
  ASSERT_EQ(::read(reader, received.data(), 1), 1);
  running.send(SIGINT);
  ::close(both_ends);
  std::array<char, kPipeCapacity> buffer{};
  for (ssize_t count = 1; count > 0;) {
    count = ::read(reader, buffer.data(), buffer.size());
    ASSERT_GE(count, 0);
    received.append(buffer.data(), static_cast<std::size_t>(count));
  }
  ::close(reader);
  EXPECT_EQ(received, expected);
  EXPECT_EQ(running.wait(), kExitAfterSigint);
}

}  // namespace

}  // namespace rmap::test
