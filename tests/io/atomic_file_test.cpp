#include "io/atomic_file.hpp"

#include "io/files.hpp"
#include "support/random.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::expect_error;
using test::read_text;
using test::write_text;
using testing::ElementsAre;
using testing::IsEmpty;

mode_t mode_of(const std::filesystem::path& file) {
  struct stat status {};
  EXPECT_EQ(::stat(file.c_str(), &status), 0);
  return status.st_mode & 0777;
}

TEST(AtomicFile, appears_with_commit_and_not_before) {
  const test::TemporaryFolder folder;
  {
    AtomicFile file(folder / "a.txt");
    file.write("hello");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    EXPECT_EQ(file.size(), 5u);
    file.commit();
    EXPECT_THAT(folder.names(), ElementsAre("a.txt"));
  }
  EXPECT_EQ(read_text(folder / "a.txt"), "hello");
}

TEST(AtomicFile, needs_a_name) {
  expect_error(ErrorKind::input, "the file to write has no name", [] { AtomicFile file(""); });
}

TEST(AtomicFile, leaves_nothing_without_commit) {
  const test::TemporaryFolder folder;
  { AtomicFile(folder / "a.txt").write("hello"); }
  EXPECT_THAT(folder.names(), IsEmpty());
  write_text(folder / "a.txt", "old");
  { AtomicFile(folder / "a.txt").write(std::string(1000000, 'x')); }
  EXPECT_THAT(folder.names(), ElementsAre("a.txt"));
  EXPECT_EQ(read_text(folder / "a.txt"), "old");
}

TEST(AtomicFile, replaces_and_keeps_the_permissions) {
  const test::TemporaryFolder folder;
  write_text(folder / "old.txt", "a longer text than the new one");
  ASSERT_EQ(::chmod((folder / "old.txt").c_str(), 0640), 0);
  AtomicFile old(folder / "old.txt");
  old.write("new");
  old.commit();
  EXPECT_EQ(read_text(folder / "old.txt"), "new");
  EXPECT_EQ(mode_of(folder / "old.txt"), 0640u);

  AtomicFile fresh(folder / "fresh.txt");
  fresh.commit();
  write_text(folder / "usual.txt", "");
  EXPECT_EQ(mode_of(folder / "fresh.txt"), mode_of(folder / "usual.txt"));
}

TEST(AtomicFile, writes_pieces_of_all_sizes) {
  test::Random random(5);
  SCOPED_TRACE(random.trace());
  const test::TemporaryFolder folder;
  AtomicFile file(folder / "a.bin");
  std::string expected;
  int pieces = 0;
  for (; pieces < 300; ++pieces) {
    const int size = random.chance(0.1) ? random.integer(0, 700000) : random.integer(0, 2000);
    const std::string piece(static_cast<std::size_t>(size),
                            static_cast<char>(random.integer(0, 255)));
    file.write(piece);
    expected += piece;
    ASSERT_EQ(file.size(), expected.size());
    if (random.chance(0.05)) {
      const std::string mark = "mark";
      if (expected.size() < mark.size()) continue;
      const auto offset = static_cast<std::size_t>(
          random.integer(0, static_cast<std::int32_t>(expected.size() - mark.size())));
      file.overwrite(offset, mark);
      expected.replace(offset, mark.size(), mark);
    }
  }
  file.commit();
  EXPECT_EQ(pieces, 300);
  EXPECT_GT(expected.size(), 5000000u);
  EXPECT_TRUE(read_text(folder / "a.bin") == expected);
}

TEST(AtomicFile, several_files_of_one_target_do_not_meet) {
  const test::TemporaryFolder folder;
  AtomicFile first(folder / "a.txt");
  AtomicFile second(folder / "a.txt");
  first.write("first");
  second.write("second");
  first.commit();
  EXPECT_EQ(read_text(folder / "a.txt"), "first");
  second.commit();
  EXPECT_EQ(read_text(folder / "a.txt"), "second");
  EXPECT_THAT(folder.names(), ElementsAre("a.txt"));
}

TEST(AtomicFile, follows_links_and_leaves_them_in_place) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "there");
  write_text(folder / "there/a.txt", "old");
  std::filesystem::create_symlink("there/a.txt", folder / "link.txt");
  std::filesystem::create_symlink("link.txt", folder / "link_to_link.txt");
  AtomicFile file(folder / "link_to_link.txt");
  file.write("new");
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link_to_link.txt"));
  EXPECT_EQ(read_text(folder / "there/a.txt"), "new");
  EXPECT_THAT(folder.names(), ElementsAre("link.txt", "link_to_link.txt", "there"));

  std::filesystem::create_symlink("there/not_yet.txt", folder / "dangling.txt");
  AtomicFile created(folder / "dangling.txt");
  created.commit();
  EXPECT_TRUE(std::filesystem::is_regular_file(folder / "there/not_yet.txt"));

  std::filesystem::create_symlink("loop.txt", folder / "loop.txt");
  const std::string loop = folder / "loop.txt";
  expect_error(ErrorKind::io, "cannot write " + loop + ": Too many levels of symbolic links",
               [&] { AtomicFile{loop}; });
}

TEST(AtomicFile, takes_names_as_long_as_they_can_be) {
  const test::TemporaryFolder folder;
  const std::string name(255, 'n');
  AtomicFile file(folder / name);
  file.commit();
  EXPECT_THAT(folder.names(), ElementsAre(name));
}

TEST(AtomicFile, refuses_targets_that_cannot_be_written) {
  const test::TemporaryFolder folder;
  const std::string name = folder.path();
  expect_error(ErrorKind::io, "cannot write " + name + ": Is a directory",
               [&] { AtomicFile{name}; });
  const std::string nowhere = folder / "missing/a.txt";
  expect_error(ErrorKind::io, "cannot write " + nowhere + ": No such file or directory",
               [&] { AtomicFile{nowhere}; });
  const std::string slash = folder / "missing/";
  expect_error(ErrorKind::io, "cannot write " + slash + ": Is a directory",
               [&] { AtomicFile{slash}; });
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(AtomicFile, writes_into_pipes_and_open_descriptors_directly) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const std::string target = "/proc/self/fd/" + std::to_string(ends[1]);
  {
    AtomicFile file(target);
    file.write("through the pipe");
    expect_error(ErrorKind::io, "cannot write " + target + ": Illegal seek",
                 [&] { file.overwrite(0, "T"); });
    file.commit();
  }
  char text[64];
  const ssize_t count = ::read(ends[0], text, sizeof(text));
  EXPECT_EQ(std::string(text, static_cast<std::size_t>(std::max<ssize_t>(count, 0))),
            "through the pipe");
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(AtomicFile, appends_to_a_file_behind_an_open_descriptor) {
  // As with `command -o /dev/stdout >> all.txt`: what stands there already stays.
  const test::TemporaryFolder folder;
  write_text(folder / "all.txt", "before ");
  FILE* stream = std::fopen((folder / "all.txt").c_str(), "a");
  ASSERT_NE(stream, nullptr);
  AtomicFile file("/proc/self/fd/" + std::to_string(::fileno(stream)));
  file.write("after");
  file.commit();
  std::fclose(stream);
  EXPECT_EQ(read_text(folder / "all.txt"), "before after");
  EXPECT_THAT(folder.names(), ElementsAre("all.txt"));
}

}  // namespace
}  // namespace rmap
