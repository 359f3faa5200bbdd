#include "io/bag/sqlite_storage.hpp"

#include "io/bag/bag_samples.hpp"
#include "io/files.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <zstd.h>

namespace rmap {
namespace {

using test::expect_error;
using test::scans_of;

const std::vector<test::ReadScan> kThree = {{0, 0}, {1, 1}, {2, 2}};

void run(const std::filesystem::path& file, const char* sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(database);
  sqlite3_close(database);
}

TEST(SqliteStorage, reads_a_lone_file_and_folders) {
  const test::TemporaryFolder folder;
  // A name with what has a meaning in a URI.
  test::write_db3(test::driving_bag(3), folder / "a?b%20#c.db3");
  EXPECT_EQ(scans_of(folder / "a?b%20#c.db3"), kThree);
  for (const bool mcap : {false, true}) {
    const auto bag = folder / (mcap ? "mcap" : "db3");
    test::write_rosbag2(test::driving_bag(3), bag, mcap, 3);
    EXPECT_EQ(scans_of(bag), kThree);
  }
}

TEST(SqliteStorage, leaves_the_file_and_its_folder_alone) {
  const test::TemporaryFolder folder;
  test::write_db3(test::driving_bag(3), folder / "a.db3");
  const std::string before = test::read_text(folder / "a.db3");
  scans_of(folder / "a.db3");
  EXPECT_EQ(test::read_text(folder / "a.db3"), before);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.db3"});
}

TEST(SqliteStorage, warns_of_what_a_recorder_left_beside) {
  const test::TemporaryFolder folder;
  test::write_db3(test::driving_bag(3), folder / "a.db3");
  test::write_text(folder / "a.db3-wal", "12345");
  const auto source = open_scans(folder / "a.db3");
  ASSERT_EQ(source->notes().warnings.size(), 1u);
  EXPECT_NE(source->notes().warnings[0].find("a.db3-wal (5 bytes) are not read"),
            std::string::npos);
}

TEST(SqliteStorage, unpacks_messages_compressed_one_by_one) {
  const test::TemporaryFolder folder;
  test::TestBag bag = test::driving_bag(3);
  for (test::TestMessage& message : bag.messages) {
    message.data = test::pack(test::TestCompression::zstd, message.data);
  }
  test::write_db3(bag, folder / "a.db3");
  EXPECT_EQ(scans_of(folder / "a.db3"), kThree);
}

TEST(SqliteStorage, refuses_databases_that_are_no_bags) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.db3";
  run(file, "CREATE TABLE topics(a)");
  expect_error(ErrorKind::input,
               file +
                   " is no bag: a .db3 of rosbag2 has tables topics and messages, and messages "
                   "is missing in this database",
               [&] { open_scans(file); });
  run(file,
      "CREATE VIEW messages AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x+1 FROM c) "
      "SELECT x AS id, 1 AS topic_id, x AS timestamp, x'00' AS data FROM c");
  EXPECT_THROW(open_scans(file), Error);
}

TEST(SqliteStorage, refuses_messages_of_no_topic) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.db3";
  test::write_db3(test::driving_bag(1), file);
  run(file, "UPDATE messages SET topic_id = 77 WHERE id = 2");
  expect_error(ErrorKind::input,
               file +
                   " is damaged: message 2 is of topic 77, which the table of topics does not "
                   "hold",
               [&] { open_scans(file); });
}

}  // namespace
}  // namespace rmap
