#include "io/bag/metadata.hpp"

#include "io/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/error.hpp>

namespace rmap {
namespace {

using test::expect_error;

std::vector<std::filesystem::path> files_of(const test::TemporaryFolder& folder,
                                            const std::string& list) {
  test::write_text(folder / "metadata.yaml",
                   "rosbag2_bagfile_information:\n  version: 5\n  relative_file_paths:" + list);
  return read_bag_files(folder.path());
}

TEST(Metadata, names_files_of_the_folder) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(files_of(folder, "\n    - b_0.db3\n    - old_folder/b_1.db3\n    - ../../etc/b_2\n"),
              testing::ElementsAre(folder / "b_0.db3", folder / "b_1.db3", folder / "b_2"));
}

TEST(Metadata, says_what_is_wrong) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "metadata.yaml";
  expect_error(ErrorKind::input, file + ": the bag has no files: one at least is needed",
               [&] { files_of(folder, " []\n"); });
  expect_error(ErrorKind::input, file + ": \"..\" is no name of a file",
               [&] { files_of(folder, " [..]\n"); });
  expect_error(ErrorKind::input,
               file +
                   ": \"a.db3.zstd\" is compressed as a whole: zstd -d --rm unpacks it; then take "
                   "the ending .zstd off its name here",
               [&] { files_of(folder, " [a.db3.zstd]\n"); });
  for (const std::string& text :
       {std::string(), std::string("a"), std::string("[1]"), std::string("a: ["),
        std::string("rosbag2_bagfile_information: 5\n"), std::string(50'000, '['),
        std::string(50'000, '\xff'), std::string(300'000, '{'), std::string("&a [*a, *b]")}) {
    test::write_text(file, text);
    EXPECT_THROW(read_bag_files(folder.path()), Error) << text.substr(0, 20);
  }
  test::write_text(file, std::string((1 << 20) + 1, ' '));
  expect_error(ErrorKind::limit, file + " has 1048577 bytes, and 1048576 are allowed",
               [&] { read_bag_files(folder.path()); });
}

}  // namespace
}  // namespace rmap
