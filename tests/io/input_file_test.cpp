#include "io/input_file.hpp"

#include "io/files.hpp"
#include "io/text.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::expect_error;

TEST(InputFile, reads_in_pieces_and_the_rest) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.txt", "0123456789");
  InputFile file(folder / "a.txt");
  EXPECT_EQ(file.size(), 10u);
  EXPECT_EQ(as_text(file.head(3)), "012");
  EXPECT_EQ(as_text(file.head(99)), "0123456789");
  std::vector<std::byte> piece(4);
  file.read(piece);
  EXPECT_EQ(as_text(piece), "0123");
  EXPECT_EQ(as_text(file.read_rest()), "456789");
  EXPECT_TRUE(file.read_rest().empty());
}

TEST(InputFile, refuses_what_is_no_readable_file) {
  const test::TemporaryFolder folder;
  const std::string missing = folder / "missing.txt";
  expect_error(ErrorKind::io, "cannot open " + missing + ": No such file or directory",
               [&] { InputFile{missing}; });
  const std::string name = folder.path();
  expect_error(ErrorKind::io,
               "cannot read " + name + ": it is a folder, and must be a regular file",
               [&] { InputFile{name}; });
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  // Not waited for, though nobody writes to it.
  expect_error(ErrorKind::io,
               "cannot read " + pipe + ": it is a pipe or a device, and must be a regular file",
               [&] { InputFile{pipe}; });
}

TEST(InputFile, says_when_reading_is_not_permitted) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "secret.txt";
  test::write_text(file, "secret");
  std::filesystem::permissions(file, std::filesystem::perms::none);
  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  // Root may read everything: be somebody else for the time being.
  const bool is_root = ::geteuid() == 0;
  if (is_root) {
    ASSERT_EQ(::seteuid(65534), 0);
  }
  expect_error(ErrorKind::io, "cannot open " + file + ": Permission denied",
               [&] { InputFile{file}; });
  if (is_root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
}

TEST(InputFile, notices_that_the_file_became_shorter) {
  const test::TemporaryFolder folder;
  const std::string name = folder / "a.txt";
  test::write_text(name, "0123456789");
  InputFile file(name);
  std::filesystem::resize_file(name, 5);
  expect_error(ErrorKind::io,
               "cannot read " + name +
                   ": it had 10 bytes when it was opened and became shorter while it was read",
               [&] { file.read_rest(); });
}

}  // namespace
}  // namespace rmap
