#pragma once

#include "io/bag/bag_storage.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <rmap/error.hpp>

struct sqlite3;
struct sqlite3_stmt;

namespace rmap {

/// A `.db3` file of rosbag2: tables of topics and messages in a database of SQLite. It is opened
/// as a file that nobody changes; what a stranger may have put into it beside the tables (views,
/// triggers, functions) has no effect.
class SqliteStorage : public BagStorage {
 public:
  /// Throws Error(input) when the file is no such database.
  explicit SqliteStorage(std::filesystem::path file);

  void visit(FunctionRef<void(const BagMessage&)> use) override;
  std::span<const std::byte> read(const BagPlace& place) override;
  std::vector<BagTopic> topics() const override;
  std::string format() const override { return "sqlite3"; }
  std::vector<std::string> warnings() const override { return warnings_; }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  using Statement = std::unique_ptr<sqlite3_stmt, Finalize>;

  void open();
  void harden();
  void check_size() const;
  void read_topics();
  void require_table(const char* name) const;
  Statement prepare(std::string_view sql) const;
  bool step(sqlite3_stmt* statement) const;
  Error damaged(std::string_view problem) const;
  Error short_of_memory() const;

  std::filesystem::path file_;
  std::uint64_t file_size_ = 0;
  std::unique_ptr<sqlite3, Close> database_;
  std::map<std::int64_t, BagTopic> topics_;  ///< by id
  std::vector<std::string> warnings_;
  Statement reader_;  ///< of one message
};

}  // namespace rmap
